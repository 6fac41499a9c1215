import { readFile } from 'node:fs/promises';
import { expect, test } from '../../fixtures/test.ts';
import { TopicsPage } from '../../pages/topics-page.ts';

test('values that were published before the page opened are there, and new ones come by themselves @smoke @firefox', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/arm/angle', 'double', 0.25);
  robot.publish('/lab/arm/name', 'string', 'left arm');
  const topics = new TopicsPage(await room.atDesk());
  await topics.open();
  await topics.expandAll();
  await expect(topics.value('angle')).toContainText('0.25');
  await expect(topics.value('name')).toContainText('left arm');

  robot.publish('/lab/arm/angle', 'double', 1.75);
  await expect(topics.value('angle')).toContainText('1.75');
  robot.publish('/lab/leg/angle2', 'double', 3);
  await expect(topics.row('leg')).toBeVisible();
});

test('a topic shows how often it is published', async ({ room }) => {
  const robot = await room.program('Robot');
  let value = 0;
  const beat = setInterval(() => robot.publish('/lab/beat', 'double', value++), 20);
  const topics = new TopicsPage(await room.atDesk());
  await topics.open();
  await topics.expandAll();
  await expect(topics.rate('beat')).toHaveText(/[1-9]/);
  clearInterval(beat);
  await expect(topics.rate('beat')).not.toHaveText(/[1-9]/);
  await expect(topics.value('beat')).toContainText(String(value - 1));
});

test('topics are found by text, by glob and by client', async ({ room }) => {
  const robot = await room.program('Robot');
  const camera = await room.program('Camera');
  robot.publish('/lab/arm/angle', 'double', 1);
  robot.publish('/lab/leg/speed', 'double', 2);
  camera.publish('/studio/lens/zoom', 'double', 3);
  const topics = new TopicsPage(await room.atDesk());
  await topics.open();
  for (const [search, found] of [
    ['zoom', ['zoom']],
    ['/lab/*/angle', ['angle']],
    ['client:robot', ['angle', 'speed']],
  ] as const) {
    await topics.search.fill(search);
    for (const name of ['angle', 'speed', 'zoom']) {
      const isFound = found.some((candidate) => candidate === name);
      await expect(topics.row(name), `${name} for ${search}`).toHaveCount(isFound ? 1 : 0);
    }
  }
  await topics.search.fill('nothing is called so');
  await expect(topics.page.getByText('No matches', { exact: true })).toBeVisible();
  await topics.page.getByRole('button', { name: 'Clear the search' }).last().click();
  await expect(topics.row('lab')).toBeVisible();
});

test('a topic has an address that can be shared', async ({ room }) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/arm/position', 'vector2', { x: 0.5, y: 1.5 });
  const anna = await room.atDesk();
  const topics = new TopicsPage(anna);
  await topics.open();
  await topics.expandAll();
  await topics.row('position').click();
  await expect(topics.detail).toHaveAccessibleName('Topic /lab/arm/position');
  await expect(topics.detail).toContainText('vector2');
  await expect(topics.detail).toContainText('Robot');

  const ben = new TopicsPage(await room.withPhone());
  await ben.page.goto(new URL(anna.page.url()).pathname);
  await expect(ben.detail).toHaveAccessibleName('Topic /lab/arm/position');
  await expect(ben.detail).toContainText('1.5');
  await ben.detail.getByRole('button', { name: 'All topics' }).click();
  await expect(ben.tree).toBeVisible();
});

test('topics of a program that leaves go with it', async ({ room }) => {
  const robot = await room.program('Robot');
  const camera = await room.program('Camera');
  robot.publish('/lab/angle', 'double', 1);
  camera.publish('/studio/zoom', 'double', 3);
  const topics = new TopicsPage(await room.atDesk());
  await topics.open();
  await expect(topics.row('lab')).toBeVisible();
  await expect(topics.row('studio')).toBeVisible();
  await robot.close();
  await expect(topics.row('lab')).toHaveCount(0);
  await expect(topics.row('studio')).toBeVisible();
});

test('the tree is walked with the arrow keys', async ({ room }) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/arm/angle', 'double', 1);
  robot.publish('/studio/zoom', 'double', 3);
  const topics = new TopicsPage(await room.atDesk());
  await topics.open();
  const lab = topics.row('lab');
  await lab.focus();
  if ((await lab.getAttribute('aria-expanded')) === 'true') {
    await topics.page.keyboard.press('ArrowLeft');
  }
  await expect(lab).toHaveAttribute('aria-expanded', 'false');
  await topics.page.keyboard.press('ArrowRight');
  await expect(lab).toHaveAttribute('aria-expanded', 'true');
  await topics.page.keyboard.press('ArrowDown');
  await expect(topics.row('arm')).toBeFocused();
  await topics.page.keyboard.press('End');
  await topics.page.keyboard.press('Home');
  await expect(lab).toBeFocused();
});

test('ten thousand topics can be looked through', async ({ room }) => {
  const robot = await room.program('Robot');
  for (let index = 0; index < 10_000; index++) {
    robot.publish(`/many/${index % 100}/value-${index}`, 'double', index);
  }
  const topics = new TopicsPage(await room.atDesk());
  await topics.open();
  await expect(
    topics.page.getByRole('contentinfo').or(topics.page.locator('footer')),
  ).toContainText(/10[^\d]?000/);
  await topics.search.fill('value-7654');
  await expect(topics.value('value-7654')).toContainText(/7[^\d]?654/);
});

test('a room without topics says so and offers the first', async ({ room }) => {
  const anna = await room.atDesk();
  await anna.page.goto('/topics');
  await expect(anna.page.getByText(/^No topics yet/)).toBeVisible();
  await anna.page.getByRole('link', { name: 'Open the mouse pointer example' }).click();
  await expect(anna.page).toHaveURL(/\/examples\/mouse-pointer$/);
});

test('a value member by member shows what the record before it said', async ({ room }) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/state', 'string', '{"mode":"idle","left":1}');
  const topics = new TopicsPage(await room.atDesk());
  await topics.page.goto('/topics/%2Flab%2Fstate');
  const value = topics.detail.getByRole('list', { name: 'Value' });
  await expect(value).toContainText('"idle"');
  robot.publish('/lab/state', 'string', '{"mode":"busy","right":2}');
  await expect(value).toContainText('was "idle"');
  await expect(value).toContainText('removed, was 1');
  await expect(value).toContainText('new');
});

test('what is kept of a topic is told, and saved as a table', async ({ room }) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/point', 'vector2', { x: 0.5, y: 1 });
  const topics = new TopicsPage(await room.atDesk());
  await topics.page.goto('/topics/%2Flab%2Fpoint');
  await expect(topics.detail.getByRole('button', { name: /^1 record kept/ })).toBeVisible();
  const download = topics.page.waitForEvent('download');
  await topics.detail.getByRole('button', { name: 'Save the history as CSV' }).click();
  const file = await download;
  expect(file.suggestedFilename()).toBe('lab-point.csv');
  expect(await readFile(await file.path(), 'utf8')).toMatch(/^time,time_ms,x,y\r\n.*,0\.5,1\r\n$/);
});
