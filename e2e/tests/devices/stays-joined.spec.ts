import { AccessRole, ClientState } from '@ubii/proto';
import type { UbiiClient } from '@ubii/client-web';
import type { FlakyNetwork } from '@ubii/harness';
import type { Person } from '../../fixtures/person.ts';
import { expect, test, type Room } from '../../fixtures/test.ts';
import { ClientsPage } from '../../pages/clients-page.ts';
import { FROM_ELSEWHERE, JoinPage } from '../../pages/join-page.ts';
import { Shell } from '../../pages/shell.ts';
import { makeGrant } from '../connect/make-grant.ts';

const DEVICE = 'web-interface-smart-device';
/** Console messages of the browser itself while the network is cut. */
const CUT_OFF = [/net::ERR_/, /WebSocket connection to .* failed/];

/** Phones as smart devices, in the eyes of a program. */
async function devices(program: UbiiClient) {
  return (await program.call('deviceGetList', { elements: [{ name: DEVICE }] })).elements;
}

/** Tells a page what the browser would: it is in front, or not. */
async function show({ page }: Pick<Person, 'page'>, isShown: boolean): Promise<void> {
  await page.evaluate(
    (state) => {
      Object.defineProperty(document, 'visibilityState', { value: state, configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
    },
    isShown ? 'visible' : 'hidden',
  );
}

async function openSmartDevice(room: Room, network: FlakyNetwork, name: string): Promise<Person> {
  const phone = await room.withPhoneOver(network, name);
  phone.watch.expect(...CUT_OFF);
  await phone.page.goto('/devices/smart-device');
  return phone;
}

test('a phone is the same client with its device, subscriptions and role, whatever happens on the way [CL-40]', async ({
  master,
  room,
}) => {
  test.slow();
  const program = await room.program('stage');
  const { token } = await makeGrant(master, {
    role: AccessRole.ACCESS_ROLE_PLAYER,
    target: '/devices/smart-device',
  });
  const network = await room.network();
  const phone = await room.withPhoneOver(network, 'Mara', FROM_ELSEWHERE);
  phone.watch.expect(...CUT_OFF, /status of (401|403)/);
  const { page } = phone;
  await page.goto(`/join#${token}`);
  await new JoinPage(phone).join.click();
  await expect(page).toHaveURL(/smart-device$/);
  await expect.poll(async () => (await devices(program)).length).toBe(1);
  const before = (await devices(program))[0]!;
  const id = before.clientId;
  // Lost by a reload, kept by a reconnect
  await page.evaluate(() => void Object.assign(window, { kept: 1 }));

  const presses: string[] = [];
  program
    .subscribe(`/${id}/${DEVICE}/button`, { format: 'keyEvent' })
    .onRecord(({ value }) => presses.push(value.key));

  /** Everything is as it was: said by the master, by what reaches the phone, and by what it sends. */
  async function expectTheSame(words: string): Promise<void> {
    await expect(async () => {
      program.publish(`/${id}/${DEVICE}/show_text`, 'string', words);
      await expect(page.getByText(words)).toBeVisible({ timeout: 1_000 });
    }).toPass();
    expect(await page.evaluate(() => 'kept' in window)).toBe(true);
    const device = (await devices(program))[0]!;
    expect([device.id, device.clientId]).toEqual([before.id, id]);
    expect(device.components.map(({ topic }) => topic)).toEqual(
      before.components.map(({ topic }) => topic),
    );
    const { clients } = await program.call('clientReport', { clientIds: [id] });
    expect(clients).toMatchObject([{ role: AccessRole.ACCESS_ROLE_PLAYER, connected: true }]);
    presses.length = 0;
    await page.getByRole('button', { name: 'Button 1' }).tap();
    await expect.poll(() => presses).toContain('1');
  }
  const strip = new Shell(page).disconnectedStrip;
  await expectTheSame('From the start');

  await test.step('the network is lost, and comes back', async () => {
    const button = page.getByRole('button', { name: 'Button 1' });
    const place = await button.boundingBox();
    network.lose();
    await phone.context.setOffline(true);
    await expect(strip).toBeVisible();
    // Nothing moves under a finger
    expect(await button.boundingBox()).toEqual(place);
    network.restore();
    await phone.context.setOffline(false);
    await expectTheSame('After the network');
  });

  await test.step('it goes to another Wi-Fi, and the old socket only falls silent [CL-42]', async () => {
    network.change();
    await page.evaluate(() => {
      const { connection } = navigator as { connection?: EventTarget };
      connection?.dispatchEvent(new Event('change'));
    });
    // The way to it is too quick for an eye: nothing would come over the old socket.
    await expectTheSame('After the Wi-Fi');
  });

  await test.step('it sleeps, and the socket does not survive it', async () => {
    const cdp = await phone.context.newCDPSession(page);
    await show(phone, false);
    await cdp.send('Page.setWebLifecycleState', { state: 'frozen' });
    network.lose();
    // The master has given it up meanwhile: its values are gone, it is not.
    await expect
      .poll(async () => {
        const { elements } = await program.call('clientGetList', { elements: [{ id }] });
        return elements[0]?.state;
      })
      .toBe(ClientState.UNAVAILABLE);
    network.restore();
    await cdp.send('Page.setWebLifecycleState', { state: 'active' });
    await show(phone, true);
    await expectTheSame('After the sleep');
  });

  await test.step('the master is started again', async () => {
    await master.stop();
    await expect(strip).toBeVisible();
    await master.restart();
    await program.call('topicList');
    await expectTheSame('After the master');
    await expect(strip).toBeHidden();
  });
});

test('clients that leave and lost clients are distinguished, and two tabs of a phone are one device [EX-55] [CL-45]', async ({
  room,
}) => {
  const program = await room.program('stage');
  const desk = await room.atDesk('Desk');
  const clients = new ClientsPage(desk);
  await clients.open();
  const network = await room.network();
  const mara = await openSmartDevice(room, network, 'Mara');
  await expect(clients.row('Mara')).toBeVisible();

  await test.step('its page and its battery are seen [EX-56]', async () => {
    await clients.row('Mara').click();
    const link = clients.detail('Mara').getByRole('region', { name: 'Connection' });
    await expect(link).toContainText('visible');
    await expect(link).toContainText('100 %');
    await expect(link).toContainText('charging');
    await show(mara, false);
    await expect(link).toContainText('hidden');
  });

  await test.step('a second tab in front is the device, the first one rests, and says so', async () => {
    await expect.poll(async () => (await devices(program)).length).toBe(1);
    const [first] = await devices(program);
    const second = await mara.context.newPage();
    await second.goto('/devices/smart-device');
    const note = second.getByRole('status').filter({ hasText: 'also open in another tab' });
    await expect(note).toBeVisible();
    await expect
      .poll(async () =>
        (await devices(program)).map(({ clientId }) => clientId === first!.clientId),
      )
      .toEqual([false]);
    await second.close();
    await expect
      .poll(async () => (await devices(program)).map(({ clientId }) => clientId))
      .toEqual([first!.clientId]);
    await show(mara, true);
  });

  const gone = desk.page.getByRole('list', { name: 'Clients that left recently' });
  await test.step('a button: it has left, at once, and can come back', async () => {
    await mara.page.getByRole('button', { name: 'Change your name' }).tap();
    await mara.page.getByRole('button', { name: 'Disconnect', exact: true }).tap();
    await expect(clients.row('Mara')).toHaveCount(0);
    await expect(gone).toContainText(/Mara left/);
    await expect(desk.page.getByRole('article', { name: 'No such client' })).toContainText(
      /Mara left, .+ ago/,
    );
    await mara.page.getByRole('button', { name: 'Connect', exact: true }).tap();
    await expect(clients.row('Mara')).toBeVisible();
    await expect(clients.note).toContainText('Mara reconnected.');
  });

  await test.step('the network breaks: it is silent, then lost', async () => {
    network.lose();
    await expect(clients.row('Mara')).toContainText('silent');
    await expect(clients.row('Mara')).toContainText('lost');
    await expect(clients.note).toContainText('Mara lost its connection.');
    await desk.page.goto('/');
    const row = desk.page.getByRole('listitem').filter({ hasText: 'Mara' }).last();
    await expect(row).toContainText(/lost, \d/);
    network.change();
    await mara.page.evaluate(() => window.dispatchEvent(new Event('online')));
    await expect(row).not.toContainText('lost');
  });

  await test.step('the page is closed: it has left, and the list says when', async () => {
    await mara.page.close();
    await expect(desk.page.getByRole('link', { name: 'Mara', exact: true })).toHaveCount(0);
    await clients.open();
    await expect(gone).toContainText(/Mara left.*ago/);
  });
});
