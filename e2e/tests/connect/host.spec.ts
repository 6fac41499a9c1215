import type { UbiiClient } from '@ubii/client-web/node';
import { SessionState } from '@ubii/proto';
import { expectAccessible, onPhone } from '../../fixtures/accessible.ts';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { FROM_ELSEWHERE, JoinPage } from '../../pages/join-page.ts';
import { Shell } from '../../pages/shell.ts';
import { makeGrant } from './make-grant.ts';

test.use({ masterStart: { flags: ['--lan', 'on', '--mdns', 'off'] } });
const REFUSED = /status of (401|403)/;

test('the host shows one code, sees who joins with it, and takes it back @smoke', async ({
  room,
}) => {
  const desk = await room.atDesk('Ben');
  await desk.page.goto('/');
  await new Shell(desk.page).button('Connect a phone').click();
  const dialog = desk.page.getByRole('dialog');
  const code = dialog.locator('[data-join-code]');
  await expect(code).toHaveText(/^[0-9A-Z]{4}-[0-9A-Z]{4}$/);
  await expect(dialog.getByRole('img', { name: /QR code/ })).toBeVisible();
  const shown = (await code.textContent()) ?? '';

  // Opened again it is the same, not another one
  await desk.page.keyboard.press('Escape');
  await desk.page.goto('/connect');
  await expect(desk.page.locator('[data-join-code]')).toHaveText(shown);
  await desk.page.getByRole('button', { name: 'Options' }).click();
  // A phone that reaches nothing cannot say why: the host can look it up
  await desk.page.getByText('The phone cannot open the page?').click();
  for (const cause of ['Client isolation', 'VPN', 'Firewall', '.local', 'certificate']) {
    await expect(desk.page.locator('details')).toContainText(cause);
  }

  const phone = await room.withPhone('Mara', FROM_ELSEWHERE);
  phone.watch.expect(REFUSED, /WebSocket/);
  const join = new JoinPage(phone);
  await phone.page.goto('/join');
  await join.type(shown);
  await join.join.click();
  await expect(desk.page.locator('[data-phone]')).toContainText('Mara');

  const grant = desk.page.locator('[data-grant]').filter({ hasText: '1 connected' });
  await grant.getByRole('button', { name: 'Revoke' }).click();
  await expect(grant).toContainText('1 device is disconnected now');
  await grant.getByRole('button', { name: 'Revoke invitation' }).click();
  await expect(desk.page.locator('[data-phone]')).toHaveCount(0);
  await phone.page.goto('/');
  await expect(join.heading).toHaveText('The host revoked this code.');
});

/** Starts a session that only counts, as a guest. */
async function startSession(guest: UbiiClient, name: string): Promise<void> {
  await guest.call('sessionRuntimeStart', {
    name,
    processingModules: [
      {
        name: 'counter',
        outputs: [{ internalName: 'count', messageFormat: 'double' }],
        processingMode: { frequency: { hertz: 10 } },
        onProcessingStringified:
          '(deltaTime, inputs, state) => ({ outputs: { count: { double: (state.count = (state.count ?? 0) + 1) } } })',
      },
    ],
  });
}

test('the host makes codes, and takes them back', async ({ master, room }) => {
  const { page } = await room.atDesk('Ben');
  await page.goto('/connect');
  await page.getByRole('button', { name: 'Options' }).click();

  await test.step('the choice of page, role and time makes the code that fits', async () => {
    const code = page.locator('[data-join-code]');
    await expect(code).toHaveText(/-\w{4}$/);
    const first = (await code.textContent()) ?? '';
    await page.getByRole('radio', { name: 'Watch' }).click();
    await expect(code).not.toHaveText(first);
    await expect(code).toHaveText(/^\w{4}-\w{4}$/);
    await page.getByRole('radio', { name: '15 minutes' }).click();
    await expect(page.locator('[data-grant]').first()).toContainText(/Viewer.*1[45] min left/);
    await page.getByRole('radio', { name: 'Take part' }).click();
    await page.getByRole('radio', { name: '8 hours' }).click();
    await expect(code).toHaveText(first);
  });

  await test.step('the full screen shows code and address, and closes', async () => {
    await page.keyboard.press('f');
    const screen = page.getByRole('region', { name: 'Full screen' });
    await expect(screen.locator('[data-join-code]')).toHaveText(/^\w{4}-\w{4}$/);
    await expect(screen.getByRole('img', { name: /QR code/ })).toBeVisible();
    await page.keyboard.press('Escape');
    await expect(screen).toBeHidden();
  });

  await test.step('what guests made is told, ended or handed over with their code, and who did what is written down [AC-91] [EX-90]', async () => {
    const first = await makeGrant(master, { label: 'Class 7b' });
    const second = await makeGrant(master, { label: 'Lab' });
    await startSession(await room.program('Mara', first.token), 'Marble');
    await startSession(await room.program('Noor', second.token), 'Northern lights');

    const grantOf = (label: string) => page.locator('[data-grant]').filter({ hasText: label });
    await test.step('ended, unless the host wants something else', async () => {
      const grant = grantOf('Class 7b');
      await expect(grant).toContainText('created 1 session (1 running)');
      await grant.getByRole('button', { name: 'Revoke' }).click();
      await expect(grant).toContainText('Nothing is deleted');
      await grant.getByRole('button', { name: 'Revoke invitation' }).click();
      await expect(grant).toHaveCount(0);
    });
    await test.step('or handed over', async () => {
      const grant = grantOf('Lab');
      await grant.getByRole('button', { name: 'Revoke' }).click();
      await grant.getByRole('radio', { name: 'Transfer to you' }).click();
      await expect(grant).toContainText('keep running. They and their code belong to you');
      await grant.getByRole('button', { name: 'Revoke invitation' }).click();
      await expect(grant).toHaveCount(0);
    });
    const { sessionList } = await callService(master.endpoints, {
      topic: '/services/session/runtime/get_list',
    });
    const states = sessionList?.elements.map(({ name, extension }) => [name, extension?.state]);
    expect(states).toEqual(
      expect.arrayContaining([
        ['Marble', SessionState.SESSION_STOPPED],
        ['Northern lights', SessionState.SESSION_RUNNING],
      ]),
    );

    await page.goto('/settings/audit');
    const entries = page.getByRole('list', { name: 'Audit log' }).getByRole('listitem');
    const started = entries.filter({ hasText: 'Mara started the session Marble' });
    await expect(started).toContainText('participant, invitation Class 7b');
    await expect(entries.filter({ hasText: 'Ben revoked the invitation' })).toHaveCount(2);
    await page.getByRole('searchbox', { name: 'Search the audit log' }).fill('northern');
    await expect(entries).toHaveCount(1);
    await expect(entries).toContainText('Noor started the session Northern lights');
  });
});

test('connecting phones is accessible', async ({ room }) => {
  const { page } = await room.atDesk('Ben', { colorScheme: 'dark' });
  await page.goto('/connect');
  await expect(page.locator('[data-join-code]')).toHaveText(/^\w{4}-\w{4}$/);
  await page.getByRole('button', { name: 'Options' }).click();
  await expectAccessible(page);
  await onPhone(page, () => expectAccessible(page));
  await page.getByRole('button', { name: 'Full screen' }).click();
  await expect(page.getByRole('region', { name: 'Full screen' })).toBeVisible();
  await expectAccessible(page);
});
