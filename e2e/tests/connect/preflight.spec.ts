import { AccessRole } from '@ubii/proto';
import { CHROMIUM_FLAGS, findChromium } from '../../fixtures/chromium.ts';
import { expect, test } from '../../fixtures/test.ts';
import { FROM_ELSEWHERE, JoinPage } from '../../pages/join-page.ts';
import { makeGrant } from './make-grant.ts';

/** A name that browsers do not hold for this machine: plain HTTP of it is no secure page. */
const NAME = 'studio.test';
test.use({
  masterStart: { flags: ['--lan', 'on', '--mdns', 'off', '--allowed-origins', `http://${NAME}:*`] },
});
test.use({
  launchOptions: {
    executablePath: findChromium(),
    args: [...CHROMIUM_FLAGS, `--host-resolver-rules=MAP ${NAME} 127.0.0.1`],
  },
});

const IPHONE =
  'Mozilla/5.0 (iPhone; CPU iPhone OS 18_0 like Mac OS X) AppleWebKit/605.1.15 (KHTML, like Gecko) Version/18.0 Mobile/15E148 Safari/604.1';
const REFUSED = /status of (401|403)/;

test('the host sees what each phone can do', async ({ master, room }) => {
  const desk = await room.atDesk('Ben');
  await desk.page.goto('/connect');
  await desk.page.getByRole('button', { name: 'Options' }).click();

  await test.step('over HTTPS all is well, and the host sees it [AC-30]', async () => {
    const { token } = await makeGrant(master, { target: '/examples' });
    const secure = master.url.replace('http:', 'https:');
    const phone = await room.withPhone('Mara', { ...FROM_ELSEWHERE, ignoreHTTPSErrors: true });
    phone.watch.expect(REFUSED, new RegExp(`request to ${secure}`));
    const join = new JoinPage(phone);
    await phone.page.goto(`${secure}/join#${token}`);
    await join.name.fill('Mara');
    // Nothing that this page needs failed
    await expect(join.row).toHaveCount(0);
    await join.join.click();
    await expect(phone.page).toHaveURL(/\/examples$/);
    const row = desk.page.locator('[data-phone]');
    await expect(row).toContainText('Mara');
    await expect(row).toContainText(/Android, Chrome/);
    // An emulated phone has no sensors, and the host sees that
    await expect(row).toContainText('Motion sensors');
  });

  await test.step('the host sees what went wrong on each phone, a viewer’s too [AC-30]', async () => {
    const phones = desk.page.locator('[data-phone]');

    await test.step('a clock that is far off', async () => {
      const { token } = await makeGrant(master, {
        role: AccessRole.ACCESS_ROLE_VIEWER,
        target: '/devices/smart-device',
      });
      const late = await room.withPhone('Lena', FROM_ELSEWHERE);
      late.watch.expect(REFUSED);
      await late.page.addInitScript(() => {
        const now = Date.now.bind(Date);
        Date.now = () => now() + 300_000;
      });
      const join = new JoinPage(late);
      await late.page.goto(`/join#${token}`);
      await expect(join.row).toContainText('The clock is off');
      await join.openChecks();
      await expect(join.fact('clock')).toContainText('5 min ahead of the host');
      await late.page.keyboard.press('Escape');
      // No waiting for the sensors: what is measured after the tap is told as well
      await join.join.click();
      await expect(phones.filter({ hasText: 'Lena' })).toContainText('Clock: 5 min ahead');

      // As a viewer it is no device, and is told so, with the way to become one
      await expect(late.page.getByText('Nothing is published')).toBeVisible();
      await late.page.getByRole('link', { name: 'Join with a player code' }).click();
      await expect(join.heading).toHaveText('Join with the code.');
      await late.page.getByRole('button', { name: 'Continue' }).click();
      await expect(late.page).toHaveURL(/smart-device$/);
    });

    await test.step('motion that an iPhone was refused', async () => {
      const { token } = await makeGrant(master, {
        role: AccessRole.ACCESS_ROLE_PLAYER,
        target: '/devices/smart-device',
      });
      const refused = await room.withPhone('Ida', { ...FROM_ELSEWHERE, userAgent: IPHONE });
      refused.watch.expect(REFUSED);
      await refused.page.addInitScript(() => {
        for (const event of [DeviceMotionEvent, DeviceOrientationEvent]) {
          Object.assign(event, { requestPermission: () => Promise.resolve('denied') });
        }
      });
      const join = new JoinPage(refused);
      await refused.page.goto(`/join#${token}`);
      // The tap on Join asks for motion
      await join.join.click();
      await expect(join.row).toContainText('Motion is blocked');
      await expect(join.row).toContainText('Touch and buttons work');
      await join.row.getByRole('button', { name: 'Ask again' }).click();
      await expect(join.row).toContainText('close the browser completely');
      await join.join.click();
      await expect(phones.filter({ hasText: 'Ida' })).toContainText('Motion access was denied');
      const { page } = refused;
      await page.getByRole('button', { name: 'Allow motion' }).click();
      await expect(page.getByText('Restart the browser to be asked again').first()).toBeVisible();
    });
  });
});

test('phones are told what they need for a secure page', async ({ master, room }) => {
  const { token } = await makeGrant(master, { target: '/devices/smart-device' });

  await test.step('plain HTTP is explained, with the way to the secure page', async () => {
    const { port } = new URL(master.url);
    const phone = await room.withPhone('Mara', FROM_ELSEWHERE);
    phone.watch.expect(REFUSED, new RegExp(NAME));
    const join = new JoinPage(phone);
    await phone.page.goto(`http://${NAME}:${port}/join#${token}`);
    await expect(join.row).toContainText('Motion and camera need the secure page');
    await expect(join.row.getByRole('link', { name: 'Open the secure page' })).toHaveAttribute(
      'href',
      `https://${NAME}:${port}/join#${token}`,
    );
    await expect(join.join).toBeVisible();

    // The help is reached from here, over plain HTTP, and shows what to compare
    await join.openChecks();
    await expect(join.fact('sensors')).toContainText('plain HTTP');
    await phone.page.getByRole('link', { name: /Certificate warnings/ }).click();
    await expect(phone.page.locator('[data-fingerprint]')).toHaveText(
      /^([0-9A-F]{2}:){31}[0-9A-F]{2}$/,
    );
    await expect(
      phone.page.getByRole('link', { name: 'Download the certificate' }),
    ).toHaveAttribute('href', '/ca.crt');
    await phone.page.getByRole('link', { name: 'Back', exact: true }).click();
    await expect(join.join).toBeVisible();
  });

  await test.step('iOS is told that it wants the certificate installed', async () => {
    const secure = master.url.replace('http:', 'https:');
    const phone = await room.withPhone('Mara', {
      ...FROM_ELSEWHERE,
      ignoreHTTPSErrors: true,
      userAgent: IPHONE,
    });
    phone.watch.expect(REFUSED, /WebSocket/, new RegExp(`request to ${secure}`));
    await phone.page.routeWebSocket(/\/preflight/, (socket) => void socket.close());
    const join = new JoinPage(phone);
    await phone.page.goto(`${secure}/join#${token}`);
    await join.row.getByRole('link', { name: 'Install the certificate' }).click();
    await expect(phone.page.getByText('Certificate Trust Settings')).toBeVisible();
    await expect(phone.page.getByRole('link', { name: 'Download the profile' })).toBeVisible();
  });
});

test('a blocked live channel is told from a master that is away', async ({ master, room }) => {
  const { token } = await makeGrant(master);
  const phone = await room.withPhone('Mara', FROM_ELSEWHERE);
  phone.watch.expect(REFUSED, /WebSocket/, /ERR_CONNECTION_REFUSED/);
  await phone.page.routeWebSocket(/\/preflight/, (socket) => void socket.close());
  const join = new JoinPage(phone);
  await phone.page.goto(`/join#${token}`);
  await expect(join.row).toContainText('Live connection is blocked');
  await join.openChecks();
  await expect(join.fact('master')).toHaveAttribute('data-state', 'good');
  await expect(join.fact('channel')).toContainText(/proxy|VPN/);
  await phone.page.keyboard.press('Escape');
  await expect(join.join).toBeVisible();

  await master.stop();
  await phone.page.evaluate(() => (location.hash = '#0000-0000'));
  await expect(join.heading).toContainText(/does not answer/);
  await phone.page.getByRole('button', { name: 'Try again' }).click();
  await join.openChecks();
  await expect(join.fact('master')).toContainText('Host not reached');
  await expect(join.fact('master')).toContainText('client isolation');
  await phone.page.keyboard.press('Escape');
  await master.restart();
  await expect(join.heading).not.toContainText(/does not answer/);
});
