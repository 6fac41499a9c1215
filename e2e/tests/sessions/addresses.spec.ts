import type { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { placedSession } from '../../fixtures/placed-session.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';
import { SessionPage } from '../../pages/session-page.ts';
import { SessionsPage } from '../../pages/sessions-page.ts';
import { Shell } from '../../pages/shell.ts';

/** @returns the id of a session that is on the disk */
async function storedSession(master: MasterProcess): Promise<string> {
  const id = await placedSession(master, { low: { x: 0, y: 0, reads: '/a', writes: '/b' } });
  await callService(master.endpoints, {
    topic: SERVICES.sessionDatabaseSave.topic,
    session: { id, name: 'Placed' },
  });
  return id;
}

test('addresses of sessions lead to them, and say so when they cannot', async ({
  master,
  room,
}) => {
  const desk = await room.atDesk('Anna');
  const anna = new GraphPage(desk);
  const sessions = new SessionsPage(desk);
  let id = '';
  await test.step('a new session opens as an empty graph, and is stored when it is saved', async () => {
    await sessions.open();
    await sessions.newSession.first().click();
    const begin = anna.page.getByRole('region', { name: 'Getting started' });
    await expect(begin).toBeVisible();
    await expect(anna.title).toHaveText('Session');
    const address = anna.page.url();

    await test.step('nothing is stored before it is saved, and nothing lost by a reload', async () => {
      await anna.page.reload();
      await expect(begin).toBeVisible();
      await new Shell(anna.page).go('Sessions');
      await expect(anna.page.getByRole('heading', { name: 'Sessions' })).toBeVisible();
      await expect(sessions.list).toHaveCount(0);
      await anna.page.goBack();
      await anna.openPalette();
      await anna.drag(anna.paletteModule('statistics'), await anna.spot(0.6, 0.4));
      await anna.rename('Mean');
      await expect(anna.life).toContainText('Save 2 changes');
      await sessions.open();
      await expect(sessions.list).toHaveCount(0);
      const unsaved = anna.page.getByRole('region', { name: /^Not saved/ });
      await unsaved.getByRole('link', { name: 'Mean' }).click();
      await expect(anna.page).toHaveURL(address);
      await expect(anna.node('Module statistics')).toBeVisible();
      await expect(anna.title).toHaveText('Mean');
    });
    await test.step('as JSON it is the same session', async () => {
      const session = new SessionPage(desk);
      await session.show('JSON');
      await expect(session.text).toHaveValue(/"Mean"/);
      await expect(anna.page).toHaveURL(`${address}/text`);
      await session.text.press('Escape');
      await expect(session.text).toBeHidden();
      await expect(session.tab('JSON')).toBeFocused();
      await expect(anna.page).toHaveURL(address);
    });
    await test.step('saved, it keeps its address and its undo', async () => {
      await anna.life.getByRole('button', { name: /^Save(?! and)/ }).click();
      await expect(anna.life).not.toContainText('Save');
      await expect(anna.page).toHaveURL(address);
      await anna.canvas.focus();
      await anna.page.keyboard.press('Control+z');
      await expect(anna.node('Module statistics')).toBeHidden();
      await anna.page.keyboard.press('Control+Shift+z');
      await expect(anna.node('Module statistics')).toBeVisible();
      await expect(anna.life).not.toContainText('Save');
      await anna.page.reload();
      await expect(anna.node('Module statistics')).toBeVisible();
      await new Shell(anna.page).go('Sessions');
      await expect(sessions.link('Mean')).toBeVisible();
      await expect(anna.page.getByRole('region', { name: /^Not saved/ })).toHaveCount(0);
    });
  });

  await test.step('the address of a session that is gone says so, and what can be done', async () => {
    for (const view of ['', '/log', '/text', '/graph']) {
      await anna.page.goto(`/sessions/00000000-0000-4000-8000-000000000000${view}`);
      await expect(anna.page.getByText('No session has this address')).toBeVisible();
      await expect(anna.page.getByRole('link', { name: 'All sessions' })).toBeVisible();
    }

    id = await storedSession(master);
    await anna.open(id);
    const ben = await room.atDesk('Ben');
    await ben.page.goto('/sessions');
    await new SessionsPage(ben).choose('Placed', 'Delete');
    await expect(anna.page.getByText('The master no longer has this session')).toBeVisible();
    await expect(anna.life).toContainText('Not started');
    await anna.page.getByRole('button', { name: 'Save again' }).click();
    await expect(new SessionsPage(ben).link('Placed')).toHaveAttribute('href', `/sessions/${id}`);
    await expect(anna.page.getByText('The master no longer has this session')).toBeHidden();
    await ben.page.close();
  });

  await test.step('addresses of stored sessions, and unsaved changes, outlive a restart of the master [SE-27]', async () => {
    await anna.open(id);
    await anna.drag(anna.paletteModule('statistics'), await anna.spot(0.6, 0.2));
    await expect(anna.life).toContainText('Save 1 change');
    await new Shell(anna.page).go('Sessions');
    await expect(sessions.row('Placed')).toContainText('your changes');

    desk.watch.expect(/net::ERR_CONNECTION_(REFUSED|RESET)/, /WebSocket connection to .* failed/);
    await master.stop();
    await expect(new Shell(anna.page).disconnectedStrip).toBeVisible();
    await master.restart();
    await expect(new Shell(anna.page).disconnectedStrip).toBeHidden();

    await test.step('the bookmark of the graph leads to it, with the changes', async () => {
      await anna.open(id);
      await expect(anna.node('Module low')).toBeVisible();
      await anna.page.getByRole('button', { name: 'Restore changes' }).click();
      await expect(anna.node('Module statistics')).toBeVisible();
      await anna.page.keyboard.press('Control+s');
      await expect(anna.life).not.toContainText('Save 1 change');
    });
    await test.step('so do that of its JSON, and the one of earlier versions', async () => {
      await master.stop();
      await expect(new Shell(anna.page).disconnectedStrip).toBeVisible();
      await master.restart();
      await expect(new Shell(anna.page).disconnectedStrip).toBeHidden();
      await expect(anna.node('Module statistics')).toBeVisible();
      const session = new SessionPage(desk);
      await anna.page.goto(`/sessions/${id}/text`);
      await expect(session.text).toHaveValue(/"statistics"/);
      await anna.page.goto(`/sessions/${id}/graph?a=b#c`);
      await expect(anna.node('Module statistics')).toBeVisible();
      await expect(anna.page).toHaveURL(new RegExp(`/sessions/${id}\\?a=b#c$`));
    });
  });
});
