import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { MousePointerPage } from '../../pages/mouse-pointer-page.ts';
import { Shell } from '../../pages/shell.ts';

/** Console messages of the browser itself while the master is unreachable. */
const UNREACHABLE = [/net::ERR_CONNECTION_(REFUSED|RESET)/, /WebSocket connection to .* failed/];

test('the master is restarted: everybody comes back as who they were, without a reload @smoke', async ({
  master,
  room,
}) => {
  const names = ['Anna', 'Ben', 'Carla'];
  const people = [
    await room.atDesk('Anna'),
    await room.atDesk('Ben'),
    await room.withPhone('Carla'),
  ];
  const pages = people.map((person) => new MousePointerPage(person));
  const shells = people.map(({ page }) => new Shell(page));
  await Promise.all(pages.map((page) => page.open()));
  for (const [index, page] of pages.entries()) {
    await page.pointTo({ x: 0.1 + index / 10, y: 0.2 });
    await expect(page.otherPointers).toHaveCount(2);
  }
  const ids = await Promise.all(pages.map((page) => page.ownId()));
  expect(new Set(ids).size).toBe(3);
  // Lost by a reload, kept by a reconnect.
  for (const { page } of people) await page.evaluate(() => void Object.assign(window, { kept: 1 }));

  for (const { watch } of people) watch.expect(...UNREACHABLE);
  await master.stop();
  for (const shell of shells) {
    await expect(shell.disconnectedStrip).toBeVisible();
    await expect(shell.disconnectedStrip).toContainText(/cannot be reached/);
  }
  await expect(
    people[0]!.page.getByText('Not connected to the master', { exact: true }),
  ).toBeVisible();

  await master.restart();
  for (const shell of shells) await expect(shell.disconnectedStrip).toBeHidden({ timeout: 60_000 });
  const restart = people[0]!.page.getByRole('status', { name: 'Restart of the master' });
  await expect(restart).toContainText('The master was restarted at');
  await restart.getByRole('button', { name: 'Dismiss the message' }).click();
  await expect(restart).toBeHidden();

  for (const [index, page] of pages.entries()) {
    await page.pointTo({ x: 0.5 + index / 10, y: 0.6 });
    expect(await page.ownId()).toBe(ids[index]);
    expect(await page.page.evaluate(() => 'kept' in window)).toBe(true);
  }
  for (const page of pages) {
    await expect(page.otherPointers).toHaveCount(2);
    for (const [other, name] of names.entries()) {
      if (page === pages[other]) continue;
      await page.expectPointer(page.pointerOf(name), { x: 0.5 + other / 10, y: 0.6 });
    }
  }

  const { clientList } = await callService(master.endpoints, {
    topic: '/services/client/get_list',
  });
  const listed = clientList!.elements.map(({ id, name }) => [id, name]);
  expect(listed.sort()).toEqual(ids.map((id, index) => [id, names[index]]).sort());
});
