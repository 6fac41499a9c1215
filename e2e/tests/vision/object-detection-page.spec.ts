import { join } from 'node:path';
import type { Locator } from '@playwright/test';
import { LAUNCH_WITH_CAMERA } from '../../fixtures/chromium.ts';
import type { Person } from '../../fixtures/person.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

test.use({ launchOptions: LAUNCH_WITH_CAMERA });

const PHOTOS = join(import.meta.dirname, '../../../packages/vision/photos');
const PATH = '/examples/object-detection';

const seen = ({ page }: Person): Locator => page.getByRole('region', { name: /^Detected now/ });
const start = ({ page }: Person): Locator =>
  page.getByRole('button', { name: 'Start', exact: true });
const choosePhoto = async ({ page }: Person, file: string): Promise<void> =>
  page.locator('input[type=file]').setInputFiles(join(PHOTOS, file));

test('the example finds objects in its clip at once, in a tab and on the master, and in photographs', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  const anna = await room.atDesk('Anna');
  const { page } = anna;
  const foreign: string[] = [];
  page.on('request', (request) => {
    const { protocol, hostname } = new URL(request.url());
    if (protocol.startsWith('http') && hostname !== 'localhost') foreign.push(request.url());
  });
  await page.goto(PATH);
  const place = (name: RegExp): Locator =>
    page
      .getByRole('radiogroup', { name: 'Node that runs the modules' })
      .getByRole('radio', { name });
  const nodeOf = async (): Promise<string | undefined> =>
    (await robot.call('sessionRuntimeGetList')).elements[0]?.processingModules[0]?.nodeId;

  await test.step('in a worker of this tab', async () => {
    await expect(place(/^Master/)).toContainText('not measured');
    await start(anna).click();
    await expect(page.getByRole('main')).toContainText(/Live| s old/);
    await expect(seen(anna)).toContainText('cup');
    await expect(place(/^This tab/)).toContainText(/\d ms/);
    await expect(page.locator('[data-label="cup"]')).toBeAttached();
    await expect(page.getByRole('term').filter({ hasText: 'Processed' })).toBeVisible();
    await expect(page.getByRole('region', { name: 'Latency from camera to screen' })).toContainText(
      'Detect',
    );
  });

  await test.step('on the master, as the same session', async () => {
    const [before] = (await robot.call('sessionRuntimeGetList')).elements;
    await place(/^Master/).click();
    const { id: masterId } = await robot.call('serverConfiguration');
    await expect.poll(nodeOf).toBe(masterId);
    await expect(place(/^Master/)).toContainText(/\d ms/);
    const [after] = (await robot.call('sessionRuntimeGetList')).elements;
    expect(after!.id).toBe(before!.id);
  });

  await test.step('in an image file, with the keypoints of the body', async () => {
    await page.getByRole('radio', { name: 'File' }).click();
    await choosePhoto(anna, 'README.md');
    await expect(page.getByRole('alert')).toContainText('README.md: The file is not a picture');
    await choosePhoto(anna, 'astronaut.jpg');
    await expect(seen(anna)).toContainText('person');
    await page.getByRole('switch', { name: /^Body/ }).click();
    await expect(page.locator('[data-bone]').first()).toBeAttached();
    await expect(page.locator('[data-label="person"]').first()).toContainText('A');
    await page.getByRole('slider', { name: 'Lowest score of an object' }).press('End');
    await expect(seen(anna)).toContainText('Nothing above the threshold');
    await expect(seen(anna)).toContainText('person, below threshold');
    await expect(page.locator('[data-shape="person"]')).toHaveCount(0);
  });

  await test.step('boxes and skeletons are drawn as long as they are wanted', async () => {
    await page.getByRole('slider', { name: 'Lowest score of an object' }).press('Home');
    await expect(page.locator('[data-shape="person"]').first()).toBeAttached();
    await page.getByRole('switch', { name: 'Boxes' }).click();
    await expect(page.locator('[data-shape="person"]')).toHaveCount(0);
    await expect(page.locator('[data-bone]').first()).toBeAttached();
    await page.getByRole('switch', { name: 'Skeletons' }).click();
    await expect(page.locator('[data-bone]')).toHaveCount(0);
  });

  await test.step('the session ends with the page, and no other host was asked', async () => {
    await page.goto('/examples');
    await expect.poll(async () => (await robot.call('sessionRuntimeGetList')).elements).toEqual([]);
    expect(foreign).toEqual([]);
  });
});

test('while a model loads, the page, the session and the graph show how far it is [PM-94]', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  const anna = await room.atDesk('Anna');
  const ben = await room.atDesk('Ben');
  let release!: () => void;
  const held = new Promise<void>((resolve) => (release = resolve));
  await anna.page.route('**/asset-sets/centernet-coco/**/*.bin', async (route) => {
    await held;
    await route.continue();
  });
  await anna.page.goto(PATH);
  await start(anna).click();
  const loading = { name: 'Loading centernet-coco for object-detection' };
  await expect(anna.page.getByRole('progressbar', loading)).toBeVisible();
  const [session] = (await robot.call('sessionRuntimeGetList')).elements;
  await ben.page.goto(`/sessions/${session!.id}/statistics`);
  await expect(ben.page.getByRole('progressbar', loading)).toBeVisible();
  const graph = new GraphPage(ben);
  await graph.open(session!.id);
  await expect(
    graph.node('Module object-detection').getByTitle(/^Loading centernet/),
  ).toBeVisible();
  release();
  await expect(anna.page.getByRole('main')).toContainText(/Live| s old/);
  await expect(anna.page.getByRole('progressbar')).toHaveCount(0);
});

test('the session of one tab looks at the pictures of another one, here of the camera of a phone', async ({
  room,
}) => {
  const anna = await room.atDesk('Anna');
  const mara = await room.withPhone('Mara', { permissions: ['camera'] });
  await mara.page.goto(PATH);
  await mara.page.getByRole('radio', { name: 'Camera' }).tap();
  await expect(mara.page.locator('video')).toBeVisible();
  await start(mara).tap();
  await expect(mara.page.getByRole('main')).toContainText(/Live| s old/);

  await anna.page.goto(PATH);
  await anna.page.getByRole('radio', { name: 'Topic' }).click();
  await expect(start(anna)).toHaveAccessibleDescription('Choose a topic first.');
  await anna.page.getByRole('button', { name: 'Choose a topic' }).click();
  await anna.page.getByRole('button', { name: '/web-example-object-detection/image Mara' }).click();
  await start(anna).click();
  await expect(anna.page.getByRole('main')).toContainText(/Live| s old/);
  await expect(mara.page.getByRole('main')).toContainText('Anna receives these pictures.');
});
