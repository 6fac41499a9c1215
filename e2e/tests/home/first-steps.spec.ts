import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';

test('home says how the master is, and what to do first while nothing happens', async ({
  room,
}) => {
  const { page } = await room.atDesk('Anna');
  await page.goto('/');
  await expect(page.getByText(/ is up since /)).toContainText(
    /takes\s+\d+ % of the processor and\s+\d+ MB of memory, receives\s+\d+.*records\/s,\s+nothing to warn of/,
  );
  const steps = page.getByRole('list', { name: 'What to do first' });
  await expect(steps.getByRole('button', { name: /^Connect a phone/ })).toBeVisible();
  await steps.getByRole('link', { name: /^Make a session/ }).click();
  await expect(page).toHaveURL(/\/sessions\/new$/);
  await new Shell(page).go('Home');
  await expect(steps).toBeVisible();
  await room.program('Robot');
  await expect(steps).toHaveCount(0);
});

test('home draws what the master takes', async ({ room }) => {
  const { page } = await room.atDesk();
  await page.goto('/');
  for (const name of ['Thread busy', 'All cores', 'Event-loop delay']) {
    await expect(
      page.getByRole('img', { name: new RegExp(`^${name} over the last ten minutes: now \\d`) }),
    ).toBeVisible();
  }
});
