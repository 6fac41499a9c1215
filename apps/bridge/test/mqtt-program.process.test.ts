import { readFileSync } from 'node:fs';
import type { UbiiClient } from '@ubii/client-web/node';
import { temporaryFolder } from '@ubii/program/testing';
import { startMosquitto, startNats, type Mosquitto } from '@ubii/harness';
import { connectAsync } from 'mqtt';
import type { MqttClient } from 'mqtt';
import { afterAll, beforeAll, describe, expect, it, onTestFinished, vi } from 'vitest';
import { Inbox } from '../src/testing/inbox.ts';
import { joinAs, mappingFile, startBridge, startMaster } from './programs.ts';
import type { Printed } from './programs.ts';

// Each test starts several programs, which takes long on a busy machine.
vi.setConfig({ testTimeout: 60_000 });
const POLL = { timeout: 30_000 };

let broker: Mosquitto;
beforeAll(async () => {
  broker = await startMosquitto();
});
afterAll(() => broker?.close());

async function openPeer(filter: string) {
  const peer = await connectAsync(broker.url, { protocolVersion: 5 });
  onTestFinished(() => peer.endAsync(true));
  const got = new Inbox<string>();
  peer.on('message', (address, payload) => got.add(`${address} ${payload.toString()}`.trim()));
  await peer.subscribeAsync(filter, { qos: 1 });
  return { peer, got };
}

async function collect(client: UbiiClient, glob: string) {
  const got = new Inbox<string>();
  const subscription = client.subscribe({ glob });
  subscription.onRecord(({ topic, value }) => got.add(`${topic} ${JSON.stringify(value)}`));
  await subscription.ready;
  return got;
}

/** The bridge listens as soon as it has logged that. */
async function connected(bridge: ReturnType<typeof startBridge>): Promise<Printed> {
  await bridge.says(`Connected to ${broker.url}`);
  return bridge.ready<Printed>();
}

const publish = (peer: MqttClient, topic: string, text: string, retain = false) =>
  peer.publishAsync(topic, text, { qos: 1, retain });

/** Starts two bridges to the broker. */
async function startTwo(root: string, masters: readonly string[], isOther = false) {
  const bridges = [];
  for (const [index, url] of masters.entries()) {
    const file = mappingFile({
      mappings: [
        {
          name: isOther ? `mapping ${index}` : 'mapping',
          direction: 'both',
          qos: 1,
          foreign: `${root}/+`,
          topic: `/${root}/{1}`,
          format: 'double',
        },
      ],
    });
    const bridge = startBridge([broker.url, '--name', `bridge ${index}`], url, file);
    await bridge.says(/Stands by|Passes its mappings/);
    await connected(bridge);
    bridges.push(bridge);
  }
  return bridges;
}

/**
 * Returns what has come of the topics `in` and `out` with an index from the other side. What goes round would pass values that are sent later on
 * the way: both sides have got them when they have come.
 */
async function passedBy(sides: {
  readonly root: string;
  readonly index: number;
  readonly peer: MqttClient;
  readonly client: UbiiClient;
  readonly records: Inbox<string>;
  readonly got: Inbox<string>;
  readonly count: number;
}): Promise<readonly string[]> {
  const { root, index, peer, client, records, got, count } = sides;
  const timesOf = (lines: readonly string[], line: string) =>
    lines.filter((one) => one === line).length;
  for (const value of [10 * index + 3, 10 * index + 4]) {
    await publish(peer, `${root}/end`, `${value}`);
    client.publish(`/${root}/last`, 'double', value);
    await expect
      .poll(() => timesOf(records.all, `/${root}/end ${value}`), POLL)
      .toBeGreaterThanOrEqual(count);
    await expect
      .poll(() => timesOf(got.all, `${root}/last ${value}`), POLL)
      .toBeGreaterThanOrEqual(count);
  }
  const own = [`/${root}/out${index} 2`, `${root}/in${index} 1`];
  for (const [lines, line] of [
    [records.all, own[0]!],
    [got.all, own[1]!],
  ] as const) {
    // What each side has published itself is there once.
    expect(timesOf(lines, line)).toBe(1);
  }
  return [...records.all, ...got.all].filter(
    (line) => new RegExp(`/(in|out)${index} `).test(line) && !own.includes(line),
  );
}

/** Resolves when a message comes from all bridges: what a client wants is known at other masters a moment after its subscription. */
async function untilAllPass(
  root: string,
  peer: MqttClient,
  records: Inbox<string>,
  count: number,
): Promise<void> {
  let sent = 0;
  await expect
    .poll(async () => {
      await publish(peer, `${root}/ready`, `${++sent}`);
      const times = new Map<string, number>();
      for (const line of records.all) times.set(line, (times.get(line) ?? 0) + 1);
      return Math.max(0, ...times.values());
    }, POLL)
    .toBeGreaterThanOrEqual(count);
}

describe('the bridge as a process, with Mosquitto', () => {
  it('passes values both ways, and follows its file [BR-2] [BR-4] [BR-33]', async () => {
    const { url } = await startMaster();
    const client = await joinAs(url);
    const { peer, got } = await openPeer('one/#');
    const records = await collect(client, '/one/**');
    const file = mappingFile({
      mappings: [
        { direction: 'in', foreign: 'one/sensors/+', topic: '/one/{1}', format: 'double' },
        { direction: 'out', foreign: 'one/out/{1}', topic: '/one/out/*', qos: 1 },
      ],
    });
    const bridge = startBridge([broker.url], url, file);
    const { id } = await connected(bridge);
    await publish(peer, 'one/sensors/kitchen', '21.5');
    expect(await records.next()).toBe('/one/kitchen 21.5');
    client.publish('/one/out/lamp', 'vector2', { x: 1, y: 2 });
    expect(await got.next((line) => line.startsWith('one/out'))).toBe('one/out/lamp {"x":1,"y":2}');

    const reports = await collect(client, `/${id}/bridge`);
    const report = await reports.next((line) => line.includes('\\"passed\\":1'));
    expect(report).toContain('\\"status\\":\\"connected\\"');

    mappingFile({ mappings: [{ direction: 'in', foreign: 'x', topic: '/ubii/x' }] }, file);
    await bridge.says('The mappings stay as they are.');
    const next = { direction: 'in', foreign: 'one/next', topic: '/one/next', format: 'bool' };
    mappingFile({ mappings: [next] }, file);
    await bridge.says('1 mapping in');
    // The subscription at the broker follows the log line.
    await expect
      .poll(async () => {
        await publish(peer, 'one/next', '"on"');
        return records.all.includes('/one/next true');
      }, POLL)
      .toBe(true);
  });

  it('of two bridges with the same mappings, one passes them, and the other one takes over [BR-24]', async () => {
    const { url } = await startMaster();
    const client = await joinAs(url);
    const bridges = await startTwo('two', [url, url]);
    const { peer, got } = await openPeer('two/#');
    const records = await collect(client, '/two/**');
    await publish(peer, 'two/in0', '1');
    client.publish('/two/out0', 'double', 2);
    const passed = await passedBy({ root: 'two', index: 0, peer, client, records, got, count: 1 });
    expect(passed).toEqual(['/two/in0 1', 'two/out0 2']);
    const active = bridges.find(({ stderr }) => !stderr.includes('Stands by'));
    const other = bridges.find((bridge) => bridge !== active);
    await active!.kill();
    await expect
      .poll(async () => {
        await publish(peer, 'two/in', '5');
        return records.all.includes('/two/in 5');
      }, POLL)
      .toBe(true);
    expect(other!.stderr).toMatch(/Passes its mappings\s[^]*$/);
  });

  it.each([
    ['the same mappings pass each message once', 'same', 1],
    ['other mappings pass each message once each, and none comes back', 'other', 2],
  ])(
    'two bridges at two masters of a cluster with %s [BR-21] [BR-22] [BR-24]',
    async (_name, root, count) => {
      const nats = await startNats({ jetstream: true });
      onTestFinished(() => nats.stop());
      const start = () => startMaster({ flags: ['--cluster', nats.url] });
      const masters = [await start(), await start()].map(({ url }) => url);
      await startTwo(root, masters, count > 1);
      for (const [index, url] of masters.entries()) {
        const client = await joinAs(url);
        const { peer, got } = await openPeer(`${root}/#`);
        const records = await collect(client, `/${root}/**`);
        await untilAllPass(root, peer, records, count);
        await publish(peer, `${root}/in${index}`, '1');
        client.publish(`/${root}/out${index}`, 'double', 2);
        const passed = await passedBy({ root, index, peer, client, records, got, count });
        const expected = [`/${root}/in${index} 1`, `${root}/out${index} 2`];
        expect(passed).toEqual(expected.flatMap((line) => Array(count).fill(line)));
        await peer.endAsync(true);
        await client.close();
      }
    },
  );

  it('a retained value is there on both sides, and ends on both [BR-12] [BR-13]', async () => {
    const { url } = await startMaster();
    const client = await joinAs(url);
    const { peer } = await openPeer('nothing');
    await publish(peer, 'kept/in', '1', true);
    client.publish('/kept/out', 'double', 2);
    const file = mappingFile({
      mappings: [
        {
          direction: 'both',
          foreign: 'kept/+',
          topic: '/kept/{1}',
          format: 'double',
          retained: true,
          qos: 1,
        },
      ],
    });
    await connected(startBridge([broker.url], url, file));
    const records = await collect(client, '/kept/in');
    expect(await records.next()).toBe('/kept/in 1');
    const { got } = await openPeer('kept/out');
    expect(await got.next()).toBe('kept/out 2');
    await publish(peer, 'kept/in', '', true);
    const topics = async (): Promise<boolean> => {
      const later = await collect(client, '/kept/in');
      return later.all.length === 0;
    };
    await expect.poll(topics, POLL).toBe(true);
    client.endTopic('/kept/out');
    expect(await got.next()).toBe('kept/out');
  });

  it('Home Assistant finds the devices of the master, and loses them [BR-50] [BR-51]', async () => {
    const { url } = await startMaster();
    const client = await joinAs(url);
    const { peer, got } = await openPeer('#');
    const device = await client.registerDevice({
      name: 'lamp',
      components: [
        { name: 'brightness', format: 'double' },
        { name: 'on', format: 'bool', ioType: 'subscriber' },
        { name: 'where', format: 'vector3' },
      ],
    });
    const commands = await collect(client, `/${client.id}/lamp/on`);
    const file = mappingFile({ mappings: [], homeAssistant: {}, availability: 'ha/bridge' });
    const bridge = startBridge([broker.url], url, file);
    await connected(bridge);
    const config = await got.next((line) => line.includes('/brightness/config'));
    expect(config).toContain('homeassistant/sensor/ubii_');
    const { state_topic: stateTopic } = JSON.parse(config.slice(config.indexOf('{'))) as {
      state_topic: string;
    };
    device.component('brightness').publish(0.5);
    expect(await got.next((line) => line.startsWith(stateTopic))).toBe(`${stateTopic} 0.5`);
    await peer.publishAsync(stateTopic.replace('/brightness', '/on/set'), 'true');
    expect(await commands.next()).toMatch(/ true$/);
    await device.close();
    const [topic] = config.split(' ');
    expect(await got.next((line) => line.startsWith(topic!))).toBe(topic);
    bridge.child.kill('SIGTERM');
    expect(await bridge.ended()).toBe(0);
    expect(await got.next((line) => line.startsWith('ha/bridge offline'))).toBeDefined();
  });

  it('tells a broker again what it has lost: announcements, states and values [BR-15] [BR-52]', async () => {
    const own = await startMosquitto();
    onTestFinished(() => own.close());
    const { url } = await startMaster();
    const client = await joinAs(url);
    const device = await client.registerDevice({
      name: 'lamp',
      components: [{ name: 'v', format: 'double' }],
    });
    device.component('v').publish(0.5);
    client.publish('/lost/x', 'double', 2);
    const file = mappingFile({
      homeAssistant: {},
      mappings: [{ direction: 'out', foreign: 'lost/{1}', topic: '/lost/*', retained: true }],
    });
    startBridge([own.url], url, file);
    const open = async () => {
      const peer = await connectAsync(own.url, { protocolVersion: 5 });
      onTestFinished(() => peer.endAsync(true));
      peer.on('error', () => undefined);
      const got = new Inbox<string>();
      peer.on('message', (address, payload) => got.add(`${address} ${payload.toString()}`));
      await peer.subscribeAsync(['homeassistant/#', 'ubii/+/v', 'lost/#'], { qos: 1 });
      for (const start of ['homeassistant/sensor/ubii_', 'ubii/', 'lost/x 2']) {
        await expect.poll(() => got.all.some((line) => line.startsWith(start)), POLL).toBe(true);
      }
      await peer.endAsync(true);
    };
    await open();
    await own.stop();
    await own.start();
    await open();
  });

  it('removes announcements of an earlier run for devices that no longer exist [BR-51]', async () => {
    const { url } = await startMaster();
    const client = await joinAs(url);
    await client.registerDevice({ name: 'lamp', components: [{ name: 'v', format: 'double' }] });
    const { got } = await openPeer('homeassistant/#');
    const file = mappingFile({ mappings: [], homeAssistant: {}, availability: 'ha/crash' });
    const first = startBridge([broker.url], url, file);
    await connected(first);
    const announced = await got.next((line) => line.includes('/v/config {'));
    await first.kill();
    await client.close();
    const second = startBridge([broker.url], url, file);
    await connected(second);
    const [topic] = announced.split(' ');
    // The earlier run announces it twice if it finds the master before the broker. [BR-52]
    expect(await got.next((line) => line === topic)).toBe(topic);
  });

  it('never shows the password, and takes it from no flag [BR-43]', async () => {
    const { url } = await startMaster();
    const file = mappingFile({ mappings: [] });
    const refused = startBridge(['mqtt://ada:top-secret@localhost'], url, file);
    expect(await refused.ended()).toBe(1);
    expect(refused.stderr).toContain('Use --credentials-file');
    expect(refused.stderr).not.toContain('top-secret');
    const bridge = startBridge([broker.url, '--log-level', 'debug'], url, file, {
      UBII_BRIDGE_USER: 'ada',
      UBII_BRIDGE_PASSWORD: 'top-secret',
    });
    await connected(bridge);
    expect(bridge.stdout + bridge.stderr).not.toContain('top-secret');
  });

  it('is the same client in its next run, and comes back when the master restarts [BR-40]', async () => {
    const master = await startMaster();
    const identity = `${temporaryFolder()}/identity.json`;
    const file = mappingFile({
      mappings: [{ direction: 'in', foreign: 'again/+', topic: '/again/{1}', format: 'double' }],
    });
    const target = [broker.url, '--identity', identity];
    const first = startBridge(target, master.url, file);
    const { id } = await connected(first);
    first.child.kill('SIGTERM');
    expect(await first.ended()).toBe(0);
    const second = startBridge(target, master.url, file);
    expect((await connected(second)).id).toBe(id);
    expect(JSON.parse(readFileSync(identity, 'utf8'))).toMatchObject({ clientId: id });
    await master.kill();
    await second.says('until it succeeds');
    await master.restart();
    const client = await joinAs(master.url);
    const records = await collect(client, '/again/*');
    const { peer } = await openPeer('nothing');
    await expect
      .poll(async () => {
        await publish(peer, 'again/x', '7');
        return records.all.length > 0;
      }, POLL)
      .toBe(true);
  });
});
