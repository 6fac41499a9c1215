import { AccessRole, FAREWELL_TOPIC } from '@ubii/proto';
import { expectAccessible } from '../../fixtures/accessible.ts';
import { callService } from '../../fixtures/call-service.ts';
import { LAUNCH_WITH_SENSORS } from '../../fixtures/chromium.ts';
import { expect, test, type Person } from '../../fixtures/test.ts';
import { FROM_ELSEWHERE, JoinPage } from '../../pages/join-page.ts';
import { makeGrant, revokeGrant } from './make-grant.ts';

test.use({ launchOptions: LAUNCH_WITH_SENSORS });

/** Refusals of services are answers with a status of their own, which browsers log. */
const REFUSED = /status of (401|403|429)/;

/** Somebody with a phone who is not admitted yet. */
async function stranger(
  room: { withPhone: (name: string, options: object) => Promise<Person> },
  options: object = {},
): Promise<Person> {
  const person = await room.withPhone('Mara', { ...FROM_ELSEWHERE, ...options });
  person.watch.expect(REFUSED);
  return person;
}

test('a scanned code is one tap away from the page it is for [AC-11] @smoke', async ({
  master,
  room,
}) => {
  const { token } = await makeGrant(master, { target: '/examples' });
  const phone = await stranger(room);
  const join = new JoinPage(phone);
  await phone.page.goto(`/join#${token}`);
  await expect(join.heading).toHaveText('Who are you?');
  await join.name.fill('Mara at the window');
  // The arrows choose, and Enter in the field joins
  await phone.page.getByRole('radio', { name: 'circle' }).focus();
  await phone.page.keyboard.press('ArrowRight');
  await expect(phone.page.getByRole('radio', { name: 'triangle' })).toBeChecked();
  await expect(join.row).toHaveCount(0);
  await join.name.press('Enter');
  await expect(phone.page).toHaveURL(/\/examples$/);
  // The way back does not lead through the token
  expect(await phone.page.evaluate(() => history.state?.back ?? '')).not.toContain(token);

  const desk = await room.atDesk('Ben');
  await desk.page.goto('/clients');
  await expect(desk.page.getByText('Mara at the window').first()).toBeVisible();

  // Joined is joined: a reload, and a second tab of the same phone
  await phone.page.reload();
  await expect(phone.page).toHaveURL(/\/examples$/);
  const second = await phone.context.newPage();
  await second.goto(`/join#${token}`);
  await expect(second).toHaveURL(/\/examples$/);
});

test('a typed code admits, or the page says what is wrong with it', async ({ master, room }) => {
  const good = await makeGrant(master);

  await test.step('a stranger lands where one joins, and comes to the page it wanted with a typed code', async () => {
    const { code } = await makeGrant(master, { target: '' });
    const phone = await stranger(room);
    const join = new JoinPage(phone);
    await phone.page.goto('/performance');
    await expect(join.heading).toHaveText('Join with the code.');
    await join.code.pressSequentially(code.replace('-', '').toLowerCase());
    await join.join.click();
    await expect(phone.page).toHaveURL(/\/performance/);
  });

  const phone = await stranger(room);
  const join = new JoinPage(phone);

  await test.step('what is wrong with a code is said in words, with the way out [AC-12]', async () => {
    await phone.page.goto('/join');
    await join.type('0000-0000');
    await expect(join.heading).toHaveText('This code is not valid.');

    const revoked = await makeGrant(master);
    await revokeGrant(master, revoked.id);
    await join.type(revoked.code);
    await expect(join.heading).toHaveText('The host revoked this code.');

    const short = await makeGrant(master, { lifetimeMs: 1 });
    await join.type(short.code);
    await expect(join.heading).toHaveText('This code has expired.');

    await join.code.fill(`https://some.where/join#${good.token}`);
    await join.join.click();
    await expect(phone.page).toHaveURL(/\/topics/);
  });

  await test.step('whose code is revoked while they are here comes back to joining, and hears why', async () => {
    await revokeGrant(master, good.id);
    await expect(
      phone.page.getByText(/the story wants it|revoked this code/).first(),
    ).toBeVisible();
    await phone.page.reload();
    await expect(join.heading).toHaveText('The host revoked this code.');
  });
});

test('beside somebody who tries codes, a right one waits and then joins; scanning works at once [AC-17]', async ({
  master,
  room,
}) => {
  const { token, code } = await makeGrant(master);
  const phone = await stranger(room);
  const join = new JoinPage(phone);
  await phone.page.goto('/join');
  const attacker = await phone.context.newPage();
  await attacker.goto('/join');
  await attacker.evaluate(tryCodes);
  // Now and then one comes through.
  await expect(async () => {
    await join.type('0000-0000');
    await expect(join.heading).toHaveText('Too many wrong codes from this network.', {
      timeout: 1_000,
    });
  }).toPass();
  await phone.page.goto(`/join#${token}`);
  await expect(join.join).toBeVisible();
  await phone.page.goto('/join');
  await join.type(code);
  await attacker.close();
  await expect(join.join).toBeVisible();
});

/** Tries wrong codes as fast as it can, six at a time, until its page is closed. */
function tryCodes(): void {
  const body = JSON.stringify({
    topic: '/services/ubii/join_check',
    joinCheckRequest: { token: 'ZZZZ-ZZZZ' },
  });
  const headers = { 'content-type': 'application/json' };
  const tryAgain = (): void => {
    void fetch('/services/json', { method: 'POST', headers, body }).then(tryAgain);
  };
  for (let i = 0; i < 6; i += 1) tryAgain();
}

test('a player who joined is a smart device and a controller, and changes to another code of players', async ({
  master,
  room,
}) => {
  const program = await room.program('game');
  const heard = new Set<string>();
  program.subscribe({ glob: '**' }).onRecord(({ topic }) => heard.add(topic));
  const gone: string[] = [];
  const farewells = program.subscribe(FAREWELL_TOPIC, { format: 'string' });
  farewells.onRecord(({ value }) => gone.push(value));
  await farewells.ready;
  const role = AccessRole.ACCESS_ROLE_PLAYER;
  const red = await makeGrant(master, { role, target: '/devices/smart-device' });
  const phone = await stranger(room);
  const { page } = phone;
  const join = new JoinPage(phone);
  await page.goto(`/join#${red.token}`);
  await expect(page.getByText(/^Sends touch and motion to .* until you leave/)).toBeVisible();
  await join.join.click();
  await page.getByRole('application', { name: 'Touch pad' }).tap();
  const find = async () =>
    (await program.call('deviceGetList', { elements: [{ name: 'web-interface-smart-device' }] }))
      .elements;
  await expect.poll(async () => (await find()).length).toBe(1);
  const id = (await find())[0]!.clientId;
  const cdp = await page.context().newCDPSession(page);
  await cdp.send('DeviceOrientation.setDeviceOrientationOverride', {
    alpha: 90,
    beta: 20,
    gamma: -5,
  });
  await expect.poll(() => heard.has(`${id}/orientation`)).toBe(true);
  await page.getByRole('application', { name: 'Touch pad' }).tap();
  await expect.poll(() => heard.has(`/${id}/touch_events`)).toBe(true);

  // Scanned in another tab, as cameras of phones do it: the same role, and a code that differs
  const blue = await makeGrant(master, { role, target: '/devices/controller', maxJoins: 1 });
  const tab = await phone.context.newPage();
  await tab.goto(`/join#${blue.token}`);
  await tab.getByRole('button', { name: 'Join', exact: true }).click();
  await expect(tab).toHaveURL(/\/devices\/controller$/);
  await expect(tab.getByRole('button', { name: 'A', exact: true })).toBeVisible();
  const clientsOf = async (grantId: string) => {
    const { accessGrantList } = await callService(master.endpoints, {
      topic: '/services/ubii/access_grant_list',
    });
    return accessGrantList?.elements.find((grant) => grant.id === grantId)?.clientIds ?? [];
  };
  await expect.poll(async () => (await clientsOf(blue.id)).length).toBe(1);
  expect(await clientsOf(red.id)).toEqual([id]);
  const [player] = await clientsOf(blue.id);
  // Nobody else joins with it; who has goes on, in this tab and with a reload of the link
  await tab.goto(`/join#${blue.token}`);
  await expect.poll(() => gone).toEqual([player]);
  await expect(tab).toHaveURL(/\/devices\/controller$/);
});

test('joining is accessible', async ({ master, room }) => {
  const { token } = await makeGrant(master);
  const phone = await stranger(room, { colorScheme: 'dark', reducedMotion: 'reduce' });
  const join = new JoinPage(phone);
  for (const path of ['/join', `/join#${token}`, '/connect/certificate']) {
    await phone.page.goto(path);
    await expect(join.heading).not.toHaveText(/Connecting/);
    await expectAccessible(phone.page);
  }
});
