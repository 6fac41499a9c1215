import { decode } from '@ubii/proto';
import type { Page } from '@playwright/test';
import { expect, test } from '../../fixtures/test.ts';
import { MousePointerPage } from '../../pages/mouse-pointer-page.ts';

/** Records of the frames a page sends from now on: one number a frame. */
function watchSentFrames(page: Page): number[] {
  const frames: number[] = [];
  page.on('websocket', (socket) =>
    socket.on('framesent', ({ payload }) => {
      if (typeof payload === 'string') return;
      const { topicDataRecord, topicDataRecordList } = decode(
        'ubii.topicData.TopicData',
        new Uint8Array(payload),
      );
      frames.push((topicDataRecord ? 1 : 0) + (topicDataRecordList?.elements.length ?? 0));
    }),
  );
  return frames;
}

test('the controls of the pad change what it publishes and shows', async ({ room }) => {
  const page = new MousePointerPage(await room.atDesk());
  const frames = watchSentFrames(page.page);
  await page.open();

  await test.step('the round trip is shown in numbers once the pointer moves', async () => {
    await expect(page.readout('p50')).toHaveText(/^–/);
    await expect(async () => {
      await page.wiggle();
      await expect(page.readout('p50')).toHaveText(/^\d+\.\d\s*ms$/, { timeout: 500 });
      await expect(page.readout('p95')).toHaveText(/^\d+\.\d\s*ms$/, { timeout: 500 });
    }).toPass();
  });

  await test.step('the cursor and the indicator can be hidden', async () => {
    await page.pointTo({ x: 0.5, y: 0.5 });

    await page.hideCursor.click();
    await expect(page.pad).toHaveCSS('cursor', 'none');
    await page.hideCursor.click();
    await expect(page.pad).not.toHaveCSS('cursor', 'none');

    await page.hideIndicator.click();
    await expect(page.ownPointer).toHaveCount(0);
    await page.hideIndicator.click();
    await page.expectPointer(page.ownPointer, { x: 0.5, y: 0.5 });
  });

  await test.step('immediate publishing sends each move as a message of its own', async () => {
    await page.publishImmediately.click();
    await page.pointTo({ x: 0.1, y: 0.1 });
    frames.length = 0;
    await page.moveAtOnce(8, { x: 0.8, y: 0.5 });
    await page.expectPointer(page.ownPointer, { x: 0.8, y: 0.5 });
    expect(frames).toEqual(Array(8).fill(1));
    await page.publishImmediately.click();
  });

  await test.step('a publish interval collects moves into one message', async () => {
    await page.publishInterval.focus();
    await page.page.keyboard.press('End');
    await expect(page.publishInterval).toHaveAttribute('aria-valuenow', '200');
    await page.pointTo({ x: 0.1, y: 0.1 });
    frames.length = 0;
    await page.moveAtOnce(8, { x: 0.5, y: 0.5 });
    await page.expectPointer(page.ownPointer, { x: 0.5, y: 0.5 });
    expect(frames).toHaveLength(1);
  });

  await test.step('what was chosen is there again after a reload', async () => {
    await page.hideIndicator.click();
    await page.publishImmediately.click();
    await page.page.reload();
    await expect(page.hideIndicator).toBeChecked();
    await expect(page.publishImmediately).toBeChecked();
    await expect(page.hideCursor).not.toBeChecked();
  });
});
