import { readFile } from 'node:fs/promises';
import type { UbiiClient } from '@ubii/client-web';
import type { TopicRecord } from '@ubii/proto';
import { expect, test } from '../../fixtures/test.ts';
import { PublishPage } from '../../pages/publish-page.ts';
import { Shell } from '../../pages/shell.ts';

/** Records that a topic gets from now on. */
async function listen(robot: UbiiClient, topic: string): Promise<TopicRecord[]> {
  const got: TopicRecord[] = [];
  await robot.subscribe(topic).onRecord((record) => got.push(record)).ready;
  return got;
}
const xs = (records: readonly TopicRecord[]): number[] =>
  records.map(({ value }) => Math.round((value as { x: number }).x));

/** Three places on the pad, from left to right. */
async function drag(publish: PublishPage): Promise<void> {
  const box = (await publish.page.getByTestId('pad').boundingBox())!;
  const { mouse } = publish.page;
  await mouse.move(box.x + 4, box.y + box.height / 2);
  await mouse.down();
  await mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await expect(publish.field('x')).toHaveValue(/^-?0/);
  await mouse.move(box.x + box.width - 2, box.y + box.height / 2);
  await mouse.up();
  await expect(publish.field('x')).toHaveValue(/^(0\.9\d*|1)$/);
}

test('a gesture on the pad is looped, kept and played once', async ({ room }) => {
  const robot = await room.program('Robot');
  const publish = new PublishPage(await room.atDesk());
  const gesture = publish.page.getByRole('region', { name: 'Gesture' });
  await publish.open();
  await new Shell(publish.page).expectConnected();
  await publish.topic.fill('/lab/point');
  await publish.choose('vector2');

  await test.step('a gesture on the pad is recorded and looped, and nothing is sent before it is played', async () => {
    const got = await listen(robot, '/lab/point');
    await gesture.getByRole('button', { name: 'Record' }).click();
    await expect(gesture.getByText('Recording starts with the next change')).toBeVisible();
    await drag(publish);
    await gesture.getByRole('button', { name: 'Stop recording' }).click();
    await expect(gesture.getByText(/of at most 1800 values/)).toBeVisible();
    expect(got).toHaveLength(0);

    await gesture.getByRole('button', { name: 'Play', exact: true }).click();
    await expect(gesture.getByText('Playing at')).toBeVisible();
    // Twice from the left: it is a loop.
    await expect.poll(() => xs(got).filter((x) => x === -1).length).toBeGreaterThan(1);
    await expect.poll(() => xs(got).filter((x) => x === 1).length).toBeGreaterThan(1);
    await gesture.getByRole('button', { name: 'Stop playing' }).click();
    await expect(gesture.getByText('Playing at')).toHaveCount(0);
  });

  await test.step('a gesture is kept with a snippet, exported, and there again after a reload', async () => {
    await publish.topic.fill('/lab/kept');
    const download = publish.page.waitForEvent('download');
    await gesture.getByRole('button', { name: 'Export' }).click();
    const file = JSON.parse(await readFile(await (await download).path(), 'utf8')) as {
      snippets: { gesture: { format: string; frames: unknown[] } }[];
    };
    expect(file.snippets[0]?.gesture.format).toBe('vector2');
    expect(file.snippets[0]?.gesture.frames.length).toBeGreaterThan(1);

    await publish.page.getByRole('textbox', { name: 'Name of the snippet' }).fill('swipe');
    await publish.page.getByRole('button', { name: 'Save', exact: true }).click();
    await publish.page.reload();
    await publish.page.getByRole('button', { name: 'swipe', exact: true }).click();
    await expect(gesture.getByText(/of at most 1800 values/)).toBeVisible();
    await new Shell(publish.page).expectConnected();
    const got = await listen(robot, '/lab/kept');
    await gesture.getByRole('button', { name: 'Play', exact: true }).click();
    await expect.poll(() => xs(got)).toContain(1);
    expect(got[0]?.topic).toBe('/lab/kept');
    await gesture.getByRole('button', { name: 'Stop playing' }).click();
  });

  await test.step('a gesture is played once, to its end, from where it is trimmed', async () => {
    await publish.topic.fill('/lab/once');
    const got = await listen(robot, '/lab/once');
    await gesture.getByRole('radio', { name: 'Once' }).click();
    await gesture.getByRole('slider', { name: /^Start of/ }).press('End');
    await gesture.getByRole('button', { name: 'Play', exact: true }).click();
    await expect(gesture.getByRole('button', { name: 'Play', exact: true })).toBeVisible();
    // The last record may arrive after the page says that it has ended
    await expect.poll(() => xs(got).at(-1)).toBe(1);
    expect(xs(got)).not.toContain(-1);
  });
});

test('the rotation ball is turned with keys and by touch', async ({ room }) => {
  const robot = await room.program('Robot');
  const got = await listen(robot, '/lab/turn');
  const publish = new PublishPage(await room.withPhone());
  await publish.open();
  await new Shell(publish.page).expectConnected();
  await publish.topic.fill('/lab/turn');
  await publish.choose('quaternion');
  const ball = publish.page.getByRole('group', { name: 'Rotation ball' });
  await ball.focus();
  for (let press = 0; press < 18; press++) await publish.page.keyboard.press('ArrowRight');
  await publish.publish();
  await expect
    .poll(() => got.at(-1)?.value)
    .toMatchObject({
      y: expect.closeTo(Math.SQRT1_2, 3),
      w: expect.closeTo(Math.SQRT1_2, 3),
    });
  const box = (await ball.boundingBox())!;
  const touch = (type: string, x: number) =>
    ball.dispatchEvent(type, {
      pointerId: 5,
      pointerType: 'touch',
      button: 0,
      buttons: 1,
      isPrimary: true,
      bubbles: true,
      clientX: box.x + x,
      clientY: box.y + box.height / 2,
    });
  await ball.evaluate((element) => {
    // No finger is on the screen that could be captured.
    element.setPointerCapture = () => undefined;
  });
  await touch('pointerdown', 20);
  await touch('pointermove', 20 + box.width / 2);
  await publish.publish();
  await expect.poll(() => got.at(-1)?.value).toMatchObject({ y: expect.closeTo(1, 2) });
});
