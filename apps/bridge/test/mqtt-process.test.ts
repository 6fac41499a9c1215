import { readFileSync } from 'node:fs';
import type { UbiiClient } from '@ubii/client-web/node';
import { temporaryFolder } from '@ubii/program/testing';
import { connectAsync } from 'mqtt';
import type { MqttClient } from 'mqtt';
import { afterAll, beforeAll, describe, expect, it, onTestFinished, vi } from 'vitest';
import { Inbox } from '../src/testing/inbox.ts';
import { startBroker } from './mosquitto.ts';
import type { Broker } from './mosquitto.ts';
import { joinAs, mappingFile, startBridge, startMaster } from './programs.ts';
import type { Printed } from './programs.ts';

// Each test starts several programs, which takes long on a busy machine.
vi.setConfig({ testTimeout: 60_000 });
const POLL = { timeout: 30_000 };

let broker: Broker;
beforeAll(async () => {
  broker = await startBroker();
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

/** The bridge listens as soon as it has said so. */
async function connected(bridge: ReturnType<typeof startBridge>): Promise<Printed> {
  await bridge.says(`Connected to ${broker.url}`);
  return bridge.ready<Printed>();
}

const publish = (peer: MqttClient, topic: string, text: string, retain = false) =>
  peer.publishAsync(topic, text, { qos: 1, retain });

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

  it('two bridges between the same master and broker do not amplify [BR-20] [BR-21] [BR-22]', async () => {
    const { url } = await startMaster();
    const client = await joinAs(url);
    const mapping = {
      mappings: [
        { direction: 'both', foreign: 'two/+', topic: '/two/{1}', format: 'double', qos: 1 },
      ],
    };
    for (const name of ['first', 'second']) {
      await connected(startBridge([broker.url, '--name', name], url, mappingFile(mapping)));
    }
    const { peer, got } = await openPeer('two/#');
    const records = await collect(client, '/two/**');
    await publish(peer, 'two/in', '1');
    client.publish('/two/out', 'double', 2);
    await expect
      .poll(() => records.all.filter((line) => line === '/two/in 1').length, POLL)
      .toBe(2);
    await expect.poll(() => got.all.filter((line) => line === 'two/out 2').length, POLL).toBe(2);
    // What goes round would pass these on the way: both sides answer after all that was sent before.
    await publish(peer, 'two/end', '3');
    client.publish('/two/last', 'double', 4);
    await expect
      .poll(() => records.all.filter((line) => line === '/two/end 3').length, POLL)
      .toBe(2);
    await expect.poll(() => got.all.filter((line) => line === 'two/last 4').length, POLL).toBe(2);
    const counted = (lines: readonly string[], start: string): number =>
      lines.filter((line) => line.startsWith(start)).length;
    expect([counted(records.all, '/two/in'), counted(records.all, '/two/out')]).toEqual([2, 1]);
    expect([counted(got.all, 'two/in'), counted(got.all, 'two/out')]).toEqual([1, 2]);
  });

  it('a retained value is there on both sides, and ends on both [BR-12] [BR-13]', async () => {
    const { url } = await startMaster();
    const client = await joinAs(url);
    const { peer } = await openPeer('nothing');
    await publish(peer, 'kept/in', '1', true);
    client.publish('/kept/out', 'double', 2);
    const file = mappingFile({
      mappings: [
        {
          ...{ direction: 'both', foreign: 'kept/+', topic: '/kept/{1}', format: 'double' },
          ...{ retained: true, qos: 1 },
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

  it('removes what an earlier run announced and nobody has any more [BR-51]', async () => {
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
    expect(await got.next((line) => line.startsWith(topic!))).toBe(topic);
  });

  it('never shows the password, and takes it from no flag [BR-43]', async () => {
    const { url } = await startMaster();
    const file = mappingFile({ mappings: [] });
    const refused = startBridge(['mqtt://ada:top-secret@localhost'], url, file);
    expect(await refused.ended()).toBe(1);
    expect(refused.stderr).toContain('Use --credentials-file');
    expect(refused.stderr).not.toContain('top-secret');
    const bridge = startBridge([broker.url, '--log-level', 'debug'], url, file, {
      ...{ UBII_BRIDGE_USER: 'ada', UBII_BRIDGE_PASSWORD: 'top-secret' },
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
    await master.program.kill();
    await second.says('until it succeeds');
    const again = await startMaster(master.port, master.dataDir);
    const client = await joinAs(again.url);
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
