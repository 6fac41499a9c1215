import { readFile } from 'node:fs/promises';
import { expect, test } from '../../fixtures/test.ts';
import { TopicsPage } from '../../pages/topics-page.ts';

test('values that were published before the page opened are there, in plots too, and new ones come by themselves @smoke @firefox', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  for (const value of [0.75, 0.5, 0.25]) {
    robot.publish('/lab/arm/angle', 'double', value, { immediate: true });
  }
  robot.publish('/lab/arm/name', 'string', 'left arm');
  const topics = new TopicsPage(await room.atDesk());
  await topics.open();
  await topics.expandAll();
  await expect(topics.value('angle')).toContainText('0.25');
  await expect(topics.value('name')).toContainText('left arm');

  robot.publish('/lab/arm/angle', 'double', 1.75);
  await expect(topics.value('angle')).toContainText('1.75');
  await topics.row('angle').click();
  // What was before, of the flight recorder. [RC-36]
  for (const value of ['1.750', '0.250', '0.500', '0.750']) {
    await expect(topics.page.getByRole('cell', { name: value, exact: true })).toBeVisible();
  }
  robot.publish('/lab/leg/angle2', 'double', 3);
  await expect(topics.row('leg')).toBeVisible();
});

test('the tree shows the topics that are there, while clients come and leave', async ({ room }) => {
  const anna = await room.atDesk();
  const topics = new TopicsPage(anna);
  const { page } = topics;
  await topics.open();
  await expect(page.getByText(/^No topics yet/)).toBeVisible();
  const robot = await room.program('Robot');
  const camera = await room.program('Camera');
  robot.publish('/lab/arm/angle', 'double', 1);
  robot.publish('/lab/leg/speed', 'double', 2);
  camera.publish('/studio/lens/zoom', 'double', 3);

  await test.step('the tree is walked with the arrow keys', async () => {
    const lab = topics.row('lab');
    await lab.focus();
    if ((await lab.getAttribute('aria-expanded')) === 'true') {
      await page.keyboard.press('ArrowLeft');
    }
    await expect(lab).toHaveAttribute('aria-expanded', 'false');
    await page.keyboard.press('ArrowRight');
    await expect(lab).toHaveAttribute('aria-expanded', 'true');
    await page.keyboard.press('ArrowDown');
    await expect(topics.row('arm')).toBeFocused();
    await page.keyboard.press('End');
    await page.keyboard.press('Home');
    await expect(lab).toBeFocused();
  });

  await test.step('topics are found by text, by glob and by client', async () => {
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
    await expect(page.getByText('No matches', { exact: true })).toBeVisible();
    await page.getByRole('button', { name: 'Clear the search' }).last().click();
    await expect(topics.row('lab')).toBeVisible();
  });

  await test.step('a topic shows how often it is published', async () => {
    let value = 0;
    const beat = setInterval(() => robot.publish('/lab/beat', 'double', value++), 20);
    await topics.expandAll();
    await expect(topics.rate('beat')).toHaveText(/[1-9]/);
    clearInterval(beat);
    await expect(topics.rate('beat')).not.toHaveText(/[1-9]/);
    await expect(topics.value('beat')).toContainText(String(value - 1));
  });

  await test.step('topics of a program that leaves go with it', async () => {
    await camera.close();
    await expect(topics.row('studio')).toHaveCount(0);
    await expect(topics.row('lab')).toBeVisible();
  });

  await test.step('a topic has an address that can be shared', async () => {
    robot.publish('/lab/position', 'vector2', { x: 0.5, y: 1.5 });
    await topics.row('position').click();
    await expect(topics.detail).toHaveAccessibleName('Topic /lab/position');
    await expect(topics.detail).toContainText('vector2');
    await expect(topics.detail).toContainText('Robot');

    const ben = new TopicsPage(await room.withPhone());
    await ben.page.goto(new URL(page.url()).pathname);
    await expect(ben.detail).toHaveAccessibleName('Topic /lab/position');
    await expect(ben.detail).toContainText('1.5');
    await ben.detail.getByRole('button', { name: 'All topics' }).click();
    await expect(ben.tree).toBeVisible();
  });

  await test.step('a room without topics says so and offers the first', async () => {
    await robot.close();
    await topics.open();
    await expect(page.getByText(/^No topics yet/)).toBeVisible();
    await page.getByRole('link', { name: 'Open the mouse pointer example' }).click();
    await expect(page).toHaveURL(/\/examples\/mouse-pointer$/);
  });
});

test('one topic tells its value and what is kept of it, and ten thousand can be looked through', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/state', 'string', '{"mode":"idle","left":1}');
  robot.publish('/lab/point', 'vector2', { x: 0.5, y: 1 });
  const topics = new TopicsPage(await room.atDesk());
  await topics.page.goto('/topics/%2Flab%2Fstate');

  await test.step('a value member by member shows what the record before it said', async () => {
    const value = topics.detail.getByRole('list', { name: 'Value' });
    await expect(value).toContainText('"idle"');
    robot.publish('/lab/state', 'string', '{"mode":"busy","right":2}');
    await expect(value).toContainText('was "idle"');
    await expect(value).toContainText('removed, was 1');
    await expect(value).toContainText('new');
  });

  await test.step('what is kept of a topic is told, and saved as a table', async () => {
    await topics.row('point').click();
    await expect(topics.detail.getByRole('button', { name: /^1 record kept/ })).toBeVisible();
    const download = topics.page.waitForEvent('download');
    await topics.detail.getByRole('button', { name: 'Save the history as CSV' }).click();
    const file = await download;
    expect(file.suggestedFilename()).toBe('lab-point.csv');
    expect(await readFile(await file.path(), 'utf8')).toMatch(
      /^time,time_ms,x,y\r\n.*,0\.5,1\r\n$/,
    );
  });

  await test.step('ten thousand topics can be looked through', async () => {
    for (let index = 0; index < 9_998; index++) {
      robot.publish(`/many/${index % 100}/value-${index}`, 'double', index);
    }
    await topics.open();
    await expect(
      topics.page.getByRole('contentinfo').or(topics.page.locator('footer')),
    ).toContainText(/10[^\d]?000/);
    await topics.search.fill('value-7654');
    await expect(topics.value('value-7654')).toContainText(/7[^\d]?654/);
  });
});
