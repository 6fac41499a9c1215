import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { Image2DDataFormat } from '@ubii/proto';
import { expect, test } from '../../fixtures/test.ts';
import { RecordingsPage } from '../../pages/recordings-page.ts';

/** A picture of one brightness; its sides are odd. */
function picture(brightness: number) {
  const [width, height] = [63, 47];
  const data = new Uint8Array(width * height).fill(brightness);
  return { width, height, data, dataFormat: Image2DDataFormat.GRAY8 };
}

/** What a page decodes of a video: its last picture. */
async function decoded(page: Page, bytes: Buffer) {
  const blank = await page.context().newPage();
  const facts = await blank.evaluate(async (base64) => {
    const video = document.createElement('video');
    video.src = `data:video/webm;base64,${base64}`;
    await new Promise((resolve, reject) => {
      video.onloadeddata = resolve;
      video.onerror = () => reject(new Error(video.error?.message));
    });
    await new Promise((resolve) => {
      video.onseeked = resolve;
      video.currentTime = video.duration;
    });
    const canvas = new OffscreenCanvas(video.videoWidth, video.videoHeight);
    const context = canvas.getContext('2d')!;
    context.drawImage(video, 0, 0);
    const [brightness = 0] = context.getImageData(30, 20, 1, 1).data;
    const { videoWidth, videoHeight, duration } = video;
    return { videoWidth, videoHeight, duration, brightness };
  }, bytes.toString('base64'));
  await blank.close();
  return facts;
}

test('a recording is exported as tables and as video, and tables are opened as recordings', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  const anna = new RecordingsPage(await room.atDesk('Anna'));
  const { page } = anna;
  // Its dialog cannot be answered here: the browser downloads as others do.
  await page.addInitScript(() => Reflect.deleteProperty(window, 'showSaveFilePicker'));
  await anna.open();
  await anna.record('Study');
  for (const [index, value] of [0.25, 0.5, 0.75].entries()) {
    robot.publish('/lab/angle', 'double', value, { immediate: true });
    robot.publish('/lab/camera', 'image2D', picture(200 - 50 * index), { immediate: true });
    await anna.expectRecords(2 * (index + 1));
  }
  await anna.button('Stop recording').click();
  const dialog = page.getByRole('dialog');

  async function exported(format: string, topic: string): Promise<{ name: string; path: string }> {
    await anna.button('Export').click();
    await dialog.getByRole('radio', { name: format }).click();
    const none = dialog.getByRole('button', { name: 'Choose none' });
    await none.click();
    await dialog.getByRole('checkbox', { name: topic }).check();
    const download = page.waitForEvent('download');
    await dialog.getByRole('button', { name: 'Export', exact: true }).click();
    const file = await download;
    await expect(dialog).toBeHidden();
    return { name: file.suggestedFilename(), path: await file.path() };
  }

  const video = await test.step('pictures become a video that plays', async () => {
    const { name, path } = await exported('Video', '/lab/camera');
    expect(name).toBe('Study lab-camera.webm');
    return decoded(page, await readFile(path));
  });
  expect(video).toMatchObject({ videoWidth: 64, videoHeight: 48 });
  expect(video.duration).toBeGreaterThan(0);
  // The last picture, 100, after the losses of the encoder.
  expect(Math.abs(video.brightness - 100)).toBeLessThan(10);

  await test.step('a table that was exported is the same recording again', async () => {
    const { name, path } = await exported('CSV', '/lab/angle');
    expect(name).toBe('Study lab-angle.csv');
    const buffer = await readFile(path);
    await anna.open();
    const files = page.locator('input[type=file]');
    await files.setInputFiles({ name, mimeType: 'text/csv', buffer });
    await dialog.getByRole('button', { name: 'Open' }).click();
    const angle = anna.track('/lab/angle');
    await angle.click();
    await anna.button('Go to the end').click();
    await expect(angle).toContainText('0.75');
  });

  await test.step('another table is opened, and uploaded', async () => {
    const buffer = Buffer.from('t;x;y\n0;1;2\n1,5;3;4\n');
    const file = { name: 'walk.csv', mimeType: 'text/csv', buffer };
    await page.locator('input[type=file]').setInputFiles(file);
    await dialog.getByRole('radio', { name: 'One topic for all numbers' }).click();
    const walk = dialog.getByRole('checkbox', { name: '/walk' });
    await expect(walk).toHaveCount(1);
    await expect(walk).toBeChecked();
    await dialog.getByRole('button', { name: 'Open' }).click();
    await expect(anna.track('/walk')).toBeVisible();
    await anna.button('Upload').click();
    await expect(anna.row('walk')).toBeVisible();
  });
});
