import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';
import { NAVIGATION_PAGES } from './navigation-pages.ts';

/** Other pages, by their addresses. */
const OTHERS = [
  '/sessions/new',
  '/sessions/new/text',
  '/modules/clock',
  '/examples/mouse-pointer',
  '/settings/master',
  '/settings/limits',
  '/settings/log',
  '/settings/licences',
  '/nowhere',
];

test('all pages fit a phone, and are reached with the thumb', async ({ room }) => {
  const { page } = await room.withPhone('A name that is as long as names of people may be');
  const shell = new Shell(page);
  const expectToFit = async (path: string): Promise<void> => {
    await expect(shell.main.getByRole('heading', { level: 1 })).toBeVisible();
    await shell.expectConnected();
    for (const width of [360, 390]) {
      await page.setViewportSize({ width, height: 780 });
      expect(await shell.overflowPx(), `overflow of ${path} at ${width} px`).toBe(0);
    }
  };

  await test.step('every page of the navigation can be shared by its address', async () => {
    for (const [name, path] of NAVIGATION_PAGES) {
      await page.goto(path);
      await expect(page).toHaveTitle(new RegExp(`^${name}`));
      await expectToFit(path);
    }
  });

  await test.step('nothing scrolls sideways on a phone 360 or 390 px wide', async () => {
    for (const path of OTHERS) {
      await page.goto(path);
      await expectToFit(path);
    }
  });

  await page.goto('/');

  await test.step('on a phone the navigation is at the bottom, in reach of the thumb', async () => {
    const box = (await shell.navigation.boundingBox())!;
    expect(box.y + box.height).toBeCloseTo(page.viewportSize()!.height, 0);
    for (const link of await shell.navigation.getByRole('link').all()) {
      const { width, height } = (await link.boundingBox())!;
      expect(Math.min(width, height)).toBeGreaterThanOrEqual(44);
    }
    await shell.go('Devices');
    await expect(page).toHaveURL(/\/devices$/);
  });

  await test.step('on a phone every page is behind More', async () => {
    for (const [name, path] of [
      ['Modules', '/modules'],
      ['Topics', '/topics'],
      ['Learn', '/learn'],
      ['Publish', '/publish'],
      ['Performance', '/performance/round-trip'],
      ['Settings', '/settings'],
    ] as const) {
      await shell.navigation.getByRole('button', { name: 'More' }).click();
      const sheet = page.getByRole('dialog', { name: 'All pages' });
      // Folded, until one of them is open.
      const tools = sheet.getByRole('button', { name: 'Tools', expanded: false });
      if (name === 'Publish') await tools.click();
      await sheet.getByRole('link', { name, exact: true }).click();
      await expect(page).toHaveURL((url) => url.pathname === path);
      await expect(sheet).toHaveCount(0);
    }
  });
});
