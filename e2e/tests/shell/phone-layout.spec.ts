import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';

const PATHS = [
  '/',
  '/sessions',
  '/sessions/new',
  '/sessions/new/text',
  '/modules',
  '/modules/clock',
  '/topics',
  '/examples',
  '/examples/mouse-pointer',
  '/settings',
  '/settings/master',
  '/settings/limits',
  '/settings/log',
  '/settings/licences',
  '/nowhere',
];

test('nothing scrolls sideways on a phone 360 or 390 px wide', async ({ room }) => {
  const { page } = await room.withPhone('A name that is as long as names of people may be');
  const shell = new Shell(page);
  for (const path of PATHS) {
    await page.goto(path);
    await expect(shell.main.getByRole('heading', { level: 1 })).toBeVisible();
    await shell.expectConnected();
    for (const width of [360, 390]) {
      await page.setViewportSize({ width, height: 780 });
      expect(await shell.overflowPx(), `overflow of ${path} at ${width} px`).toBe(0);
    }
  }
});

test('on a phone the navigation is at the bottom, in reach of the thumb', async ({ room }) => {
  const { page } = await room.withPhone();
  await page.goto('/');
  const shell = new Shell(page);
  const box = (await shell.navigation.boundingBox())!;
  expect(box.y + box.height).toBeCloseTo(page.viewportSize()!.height, 0);
  for (const link of await shell.navigation.getByRole('link').all()) {
    const { width, height } = (await link.boundingBox())!;
    expect(Math.min(width, height)).toBeGreaterThanOrEqual(44);
  }
  await shell.go('Topics');
  await expect(page).toHaveURL(/\/topics$/);
});
