import { countLoadedScripts } from '../../fixtures/loaded-scripts.ts';
import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';

test('home says how the master is, and what to do first while nothing happens @smoke', async ({
  room,
}) => {
  const { page } = await room.atDesk('Anna');
  await page.goto('/');
  await expect(page.getByText(/ has been running since /)).toContainText(
    /uses\s+\d+ % CPU and\s+\d+ MB of memory. It receives\s+\d+.*records? per second\.\s+No warnings\./,
  );
  const steps = page.getByRole('list', { name: 'First steps' });
  await expect(steps.getByRole('button', { name: /^Connect a phone/ })).toBeVisible();
  await steps.getByRole('link', { name: /^Create a session/ }).click();
  await expect(page.getByRole('region', { name: 'Getting started' })).toBeVisible();
  await new Shell(page).go('Home');
  await expect(steps).toBeVisible();
  await room.program('Robot');
  await expect(steps).toHaveCount(0);
});

test('home draws what the master takes', async ({ room }) => {
  const { page } = await room.atDesk();
  await page.goto('/');
  for (const name of ['Main-thread load', 'CPU load of the master', 'Event-loop delay']) {
    await expect(
      page.getByRole('img', { name: new RegExp(`^${name} over the last ten minutes: now \\d`) }),
    ).toBeVisible();
  }
});

test('home explains the product with a picture until the first session exists', async ({
  room,
}) => {
  const { page } = await room.atDesk();
  await page.goto('/');
  const intro = page.getByRole('region', { name: 'What Ubi-Interact does' });
  await expect(intro.getByText('Ubi-Interact connects phones')).toBeVisible();
  await expect(intro.getByRole('img', { name: /module mirrors/ })).toBeVisible();
  const robot = await room.program('Robot');
  await robot.call('sessionRuntimeAdd', { name: 'First' });
  await expect(page.getByRole('list', { name: 'Sessions' })).toContainText('First');
  await expect(intro).toHaveCount(0);
});

test('a cold load of home takes less than 200 kB of JavaScript, headers included @smoke', async ({
  room,
}) => {
  const { page } = await room.atDeskForTheFirstTime();
  const bytes = await countLoadedScripts(page);
  await page.goto('/');
  await expect(page.getByRole('region', { name: 'What Ubi-Interact does' })).toBeVisible();
  await expect(page.getByRole('table', { name: 'Clients' }).getByRole('link')).toHaveCount(1);
  await page.waitForLoadState('networkidle');
  expect(bytes()).toBeGreaterThan(100_000);
  expect(bytes()).toBeLessThan(200_000);
});

test('the first screen of a phone is what it can do here', async ({ room }) => {
  const { page } = await room.withPhone('Mara');
  await page.goto('/');
  const start = page.getByRole('region', { name: 'Use this device as' });
  await expect(start.getByRole('link', { name: /^Smart device/ })).toBeInViewport();
  await start.getByRole('link', { name: /^Controller/ }).tap();
  await expect(page).toHaveURL(/\/devices\/controller$/);
});
