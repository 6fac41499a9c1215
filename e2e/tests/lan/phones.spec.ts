import { expect } from '@playwright/test';
import { fromJson, type ServiceReply } from '@ubii/proto';
import { test, type Lan } from '../../fixtures/lan.ts';
import type { Person } from '../../fixtures/person.ts';
import { GathererPage, TouchedPhone } from '../../pages/gatherer-page.ts';
import { GraphPage } from '../../pages/graph-page.ts';
import { JoinPage } from '../../pages/join-page.ts';

/** Status of requests before joining, which browsers log. */
const REFUSED = /status of (401|403)/;

/** Ends of the topics that the graph must show. */
const TOPICS = ['/touch_events', '/orientation', 'smart-device/acceleration'];

/** Calls a service from a page of the master's own machine: programs of a test are in no network. */
async function askMaster({ page }: Person, request: object): Promise<ServiceReply> {
  const reply = await page.evaluate(async (body) => {
    const headers = { 'content-type': 'application/json' };
    const response = await fetch('/services/json', { method: 'POST', headers, body });
    return (await response.json()) as unknown;
  }, JSON.stringify(request));
  return fromJson('ubii.services.ServiceReply', reply);
}

/** Actions of a user who scans the code of the terminal. */
async function scanAndTap(lan: Lan, phone: Person): Promise<TouchedPhone> {
  phone.watch.expect(REFUSED);
  const join = new JoinPage(phone);
  await phone.page.goto(lan.printed.joinUrl);
  await join.join.tap();
  await expect(phone.page).toHaveURL(`${lan.printed.url}/devices/smart-device`);
  return TouchedPhone.of(phone);
}

test('a phone that trusts the certificate scans and taps once, and the graph shows how it is touched and moved', async ({
  lan,
}) => {
  const phone = await lan.withPhone('Mara');
  const { page } = phone;
  const sockets: string[] = [];
  page.on('websocket', (socket) => sockets.push(socket.url()));
  const sensors = await phone.context.newCDPSession(page);
  for (const type of ['accelerometer', 'linear-acceleration', 'gyroscope'] as const) {
    await sensors.send('Emulation.setSensorOverrideEnabled', { enabled: true, type });
  }
  const desk = await lan.atDesk('Ben');
  let touched!: TouchedPhone;

  await test.step('the printed address is a secure page, with no warning on the way', async () => {
    touched = await scanAndTap(lan, phone);
    expect(await page.evaluate(() => isSecureContext)).toBe(true);
    expect(sockets).toContainEqual(expect.stringMatching(`^wss${lan.printed.url.slice(5)}/`));
  });

  const graph = new GraphPage(desk);
  await test.step('its topics are put into the graph of a session', async () => {
    await desk.page.goto('/sessions');
    const topic = '/services/session/runtime/add';
    const { session } = await askMaster(desk, { topic, session: { name: 'Mara moves' } });
    await graph.open(session!.id);
    await untilDevice();
    await touched.touch([0.3, 0.3]);
    await touched.turn(90, 20, -5);
    await accelerate(0.5);
    for (const [index, end] of TOPICS.entries()) {
      await graph.palette.getByRole('searchbox').fill(end);
      const topic = graph.palette.locator(`[data-palette-topic$="${end}"]`);
      await graph.drag(topic, await graph.spot(0.4, 0.2 + index * 0.2));
      await expect(topicNode(end)).toBeVisible();
    }
  });

  await test.step('what it does is seen there', async () => {
    await expect(topicNode('/orientation')).toContainText('90');
    await touched.turn(45, 20, -5);
    await expect(topicNode('/orientation')).toContainText('45');
    await expect(topicNode('/acceleration')).toContainText('0.5');
    await accelerate(-2.5);
    await expect(topicNode('/acceleration')).toContainText('2.5');
    await expect(topicNode('/touch_events')).toContainText('touch_start');
    await touched.lift();
    await expect(topicNode('/touch_events')).toContainText('touch_end');
  });

  await test.step('it can be installed', async () => {
    await expect
      .poll(() => page.evaluate(async () => (await navigator.serviceWorker.ready).active?.state))
      .toBe('activated');
    const { errors, url } = await sensors.send('Page.getAppManifest');
    expect([url, errors]).toEqual([`${lan.printed.url}/manifest.webmanifest`, []]);
    const { installabilityErrors } = await sensors.send('Page.getInstallabilityErrors');
    // Every browser of a test is a private one
    expect(installabilityErrors.map(({ errorId }) => errorId)).toEqual(['in-incognito']);
  });

  await test.step('without the master, words take the place of the page, and it comes back by itself', async () => {
    phone.watch.expect(/WebSocket/, /ERR_|status of 503/);
    desk.watch.expect(/WebSocket/, /ERR_/);
    await lan.master.stop();
    await page.reload();
    await expect(page.getByRole('heading')).toContainText('The master is not reachable');
    expect(await page.evaluate(() => caches.keys())).toEqual([]);
    await lan.master.restart();
    await expect(page.getByRole('application', { name: 'Touch pad' })).toBeVisible();
    await expect(page.getByRole('button', { name: 'Change your name' })).toContainText('Mara');
    await untilDevice();
    await touched.turn(10, 20, -5);
    await expect(topicNode('/orientation')).toContainText('10');
  });

  /** Wait for the registration: sensor values before it are dropped. */
  async function untilDevice(): Promise<void> {
    const topic = '/services/device/get_list';
    await expect
      .poll(async () => (await askMaster(desk, { topic })).deviceList?.elements ?? [])
      .toMatchObject([{ name: 'web-interface-smart-device' }]);
  }
  function topicNode(end: string) {
    return graph.canvas.getByRole('group', { name: new RegExp(`^Topic .*${end}$`) });
  }
  async function accelerate(x: number): Promise<void> {
    for (const type of ['accelerometer', 'linear-acceleration', 'gyroscope'] as const) {
      const reading = { xyz: { x, y: 0, z: 9.75 } };
      await sensors.send('Emulation.setSensorOverrideReadings', { type, reading });
    }
  }
});

test('four phones come and go in the gatherer over the network, and those who touch near feel it', async ({
  lan,
}) => {
  const stage = new GathererPage((await lan.atDesk('Stage')).page);
  await stage.open();
  await stage.start();
  const join = async (name: string) => {
    const phone = await lan.withPhone(name);
    await TouchedPhone.preparing(phone);
    return scanAndTap(lan, phone);
  };
  const [anna, ben, cleo] = [await join('Anna'), await join('Ben'), await join('Cleo')];
  await stage.expectPhones('Anna', 'Ben', 'Cleo');

  await anna.touch([0.3, 0.3]);
  await ben.touch([0.33, 0.32]);
  await cleo.touch([0.9, 0.9]);
  await expect(stage.touches).toHaveCount(3);
  await expect(stage.pairs).toHaveCount(1);
  await expect(anna.flash).toBeVisible();
  await expect(ben.flash).toBeVisible();
  await expect(cleo.flash).toHaveCount(0);

  await ben.page.close();
  await stage.expectPhones('Anna', 'Cleo');
  await expect(stage.pairs).toHaveCount(0);
  await expect(anna.flash).toHaveCount(0);

  const dora = await join('Dora');
  await stage.expectPhones('Anna', 'Cleo', 'Dora');
  await dora.touch([0.88, 0.9]);
  await expect(stage.pairs).toHaveCount(1);
  await expect(dora.flash).toBeVisible();
  await expect(cleo.flash).toBeVisible();
  await expect(anna.flash).toHaveCount(0);
});
