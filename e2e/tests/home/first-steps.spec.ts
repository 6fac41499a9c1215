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
