import { countLoadedScripts } from '../../fixtures/loaded-scripts.ts';
import { expect, test } from '../../fixtures/test.ts';
import { PartyPhonePage, PartyScreenPage } from '../../pages/party-pages.ts';

test('somebody watches without a seat, cheers on the big screen, and takes a seat @smoke', async ({
  room,
}) => {
  const screen = new PartyScreenPage((await room.atDesk('Big screen')).page);
  await screen.open();
  const players: PartyPhonePage[] = [];
  for (const name of ['Mara', 'Theo']) {
    const phone = new PartyPhonePage((await room.withPhone()).page, name);
    await phone.join();
    players.push(phone);
  }
  const { page: wim } = await room.withPhone();
  const loaded = await countLoadedScripts(wim);
  await wim.goto('/party/play');
  await wim.getByRole('textbox', { name: 'Your name' }).fill('Wim');
  await wim.getByRole('button', { name: 'Watch', exact: true }).tap();
  await expect(wim.getByRole('heading', { name: 'You are watching' })).toBeVisible();
  await expect(screen.page.getByText(/1 watching/)).toBeVisible();
  await screen.expectPlayers(2);

  await screen.start();
  await screen.expectPhase('explanation');
  // The spectator is not waited for
  for (const phone of players) await phone.ready();
  await screen.expectPhase('play');
  const round = wim.getByRole('list', { name: 'Current standings' });
  await expect(round).toContainText('Mara');
  await wim.getByRole('button', { name: 'Great' }).tap();
  const cheers = screen.page.getByRole('list', { name: 'Cheers' });
  await expect(cheers).toContainText('Wim');

  await wim.getByRole('button', { name: 'Take a seat' }).tap();
  await expect(wim.getByRole('button', { name: 'Take a seat' })).toBeHidden();
  await wim.waitForLoadState('networkidle');
  // A phone has no three-dimensional engine.
  expect(loaded()).toBeGreaterThan(20_000);
  expect(loaded()).toBeLessThan(300_000);
});
