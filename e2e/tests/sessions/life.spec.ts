import { expect, test } from '../../fixtures/test.ts';
import { SessionPage } from '../../pages/session-page.ts';
import { SessionsPage } from '../../pages/sessions-page.ts';
import { Shell } from '../../pages/shell.ts';

test('the sessions of one person begin with an example, and are handled with mouse and keys', async ({
  room,
}) => {
  const anna = await room.atDesk('Anna');
  const { page } = anna;
  const sessions = new SessionsPage(anna);
  const session = new SessionPage(anna);
  await test.step('somebody who has no session starts an example, and sees what flows', async () => {
    await sessions.open();
    await sessions.startExample('Smoothing chain');
    await session.expectState('Running');
    await session.show('Statistics');
    await expect(session.fact('clock', 'Runs/s')).toHaveText(/^[1-9]/);
    await expect(session.fact('clock', 'p95')).toHaveText(/ms$/);

    await test.step('a module leads to its node', async () => {
      await session.module('clock').getByRole('button', { name: 'clock' }).click();
      await expect(session.graph.inspector.getByRole('heading', { name: 'clock' })).toBeVisible();
    });

    await test.step('Home says what runs', async () => {
      await new Shell(anna.page).go('Home');
      await expect(anna.page.getByRole('heading', { level: 1 })).toContainText('One session runs');
      await expect(anna.page.getByRole('list', { name: 'Running' })).toContainText(
        'Smoothing chain',
      );
    });
  });

  await test.step('a session is found, renamed, duplicated, deleted and brought back', async () => {
    await new Shell(anna.page).go('Sessions');
    await sessions.link('Smoothing chain').click();
    await session.expectState('Running');
    await page.keyboard.press('F2');
    const name = page.getByRole('textbox', { name: 'Name of the session' });
    await name.fill('Not this');
    await name.press('Escape');
    await expect(session.graph.title).toHaveText('Smoothing chain');
    await session.graph.rename('My chain');
    await expect(session.graph.title).toHaveText('My chain');
    await session.expectState('Applied');

    await session.choose('Duplicate');
    await expect(session.graph.title).toHaveText('My chain copy');
    await session.expectState('Not started');

    await new Shell(anna.page).go('Sessions');
    await expect(sessions.list.getByRole('listitem')).toHaveCount(2);
    await sessions.search.fill('copy');
    await expect(sessions.list.getByRole('listitem')).toHaveCount(1);
    await sessions.search.fill('');

    await test.step('what was deleted while it ran comes back and runs', async () => {
      await sessions.choose('My chain', 'Delete');
      await expect(sessions.link('My chain')).toHaveCount(0);
      await anna.page.getByRole('button', { name: 'Undo' }).click();
      await expect(sessions.row('My chain')).toContainText('Running');
      await expect(sessions.list.getByRole('listitem')).toHaveCount(2);
    });

    await test.step('all that run are stopped at once, and started again', async () => {
      const stop = anna.page.getByRole('button', { name: 'Stop all 2' });
      await anna.page.getByRole('button', { name: 'Start My chain copy' }).click();
      await stop.click();
      await expect(sessions.list.getByText('Stopped', { exact: true })).toHaveCount(2);
      await expect(stop).toBeHidden();
      await anna.page.getByRole('button', { name: 'Start again' }).click();
      await expect(sessions.list.getByText('Running', { exact: true })).toHaveCount(2);
    });
  });

  await test.step('sessions are handled with the keyboard alone', async () => {
    await sessions.choose('My chain copy', 'Delete');
    await expect(sessions.list.getByRole('listitem')).toHaveCount(1);
    await sessions.link('My chain').click();
    await session.expectState('Running');
    await page.keyboard.press('g');
    await page.keyboard.press('s');
    await expect(page).toHaveURL(/\/sessions$/);
    await sessions.link('My chain').focus();
    await page.keyboard.press('Space');
    await expect(sessions.row('My chain')).toContainText('Paused');
    await page.keyboard.press('F2');
    await page.getByRole('dialog').getByRole('textbox').fill('Renamed');
    await page.keyboard.press('Enter');
    // The dialog gives the focus back.
    await expect(sessions.link('Renamed')).toBeFocused();
    await page.keyboard.press('Delete');
    await expect(sessions.link('Renamed')).toHaveCount(0);
  });
});

test('a session is paused, resumed, stopped and started again, and others see it at once [SE-10] @smoke @firefox', async ({
  room,
}) => {
  const anna = await room.atDesk('Anna');
  const ben = await room.atDesk('Ben');
  const list = new SessionsPage(ben);
  await list.open();
  await new SessionsPage(anna).open();
  await new SessionsPage(anna).startExample('Smoothing chain');
  const session = new SessionPage(anna);
  await session.expectState('Running');
  const row = list.row('Smoothing chain');
  await expect(row).toContainText('Running');
  await expect(row).toContainText(/runs\/s/);

  await session.act('Pause');
  await session.expectState('Paused');
  await expect(row).toContainText('Paused');
  await row.getByRole('button', { name: 'Resume Smoothing chain' }).click();
  await session.expectState('Running');
  await session.act('Stop');
  await session.expectState('Stopped');
  await expect(row).toContainText('Stopped');
  await session.act('Start');
  await session.expectState('Running');
  await session.choose('Restart');
  await expect(row).toContainText('Running');
  await session.expectState('Running');
});

test('sessions outlive a restart of the master', async ({ master, room }) => {
  const anna = await room.atDesk('Anna');
  const sessions = new SessionsPage(anna);
  const session = new SessionPage(anna);
  await sessions.open();
  await sessions.startExample('Smoothing chain');
  await session.expectState('Running');
  const again = anna.page.getByRole('switch', { name: /^Resume when the master restarts/ });
  const details = anna.page.getByRole('dialog', { name: 'Smoothing chain' });
  anna.watch.expect(/net::ERR_CONNECTION_(REFUSED|RESET)/, /WebSocket connection to .* failed/);
  await test.step('a session that was started here runs again after a restart of the master [SE-24]', async () => {
    await session.choose('Details…');
    await expect(again).toBeChecked();
    await details.getByRole('button', { name: 'Done' }).click();
    await master.stop();
    await expect(new Shell(anna.page).disconnectedStrip).toBeVisible();
    await master.restart();
    await expect(new Shell(anna.page).disconnectedStrip).toBeHidden();
    await session.expectState('Running');
    await session.show('Statistics');
    await expect(session.fact('clock', 'Runs/s')).toHaveText(/^[1-9]/);
  });

  await test.step('a session that was made here is there after a restart of the master, and opens as it was [SE-21]', async () => {
    await session.choose('Details…');
    await again.click();
    await expect(again).not.toBeChecked();
    await details.getByRole('button', { name: 'Done' }).click();
    await session.expectState('Applied');
    await new Shell(anna.page).go('Sessions');
    await master.stop();
    await expect(new Shell(anna.page).disconnectedStrip).toBeVisible();
    await master.restart();
    await expect(sessions.row('Smoothing chain')).toContainText('Stopped');
    await sessions.link('Smoothing chain').click();
    await expect(session.graph.title).toHaveText('Smoothing chain');
    await session.act('Start');
    await session.expectState('Running');

    await test.step('deleted, it is gone permanently', async () => {
      await session.choose('Delete');
      await expect(anna.page).toHaveURL(/\/sessions$/);
      await expect(anna.page.getByRole('button', { name: 'Start Smoothing chain' })).toBeVisible();
    });
  });
});
