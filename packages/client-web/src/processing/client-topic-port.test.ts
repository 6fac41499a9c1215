import { decodeRecord, type KeyEvent } from '@ubii/proto';
import type { EncodedRecord } from '@ubii/pm-sandbox';
import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createTestClient } from '../testing/create-test-client.ts';
import { FakeMaster } from '../testing/fake-master.ts';
import { ClientTopicPort } from './client-topic-port.ts';
import { DeviceTopics } from './device-topics.ts';

async function setup() {
  const master = new FakeMaster();
  const { client } = createTestClient(master);
  const owner = createTestClient(master).client;
  await Promise.all([client.connect(), owner.connect()]);
  const register = (name: string) =>
    owner.registerDevice({
      name,
      components: [{ name: 'position', format: 'double', topic: `/pads/${name}` }],
    });
  const devices = new DeviceTopics(client);
  const port = new ClientTopicPort(client, devices);
  const records: EncodedRecord[] = [];
  const gone: string[] = [];
  const listener = {
    onRecord: (record: EncodedRecord) => records.push(record),
    onGone: (topic: string) => gone.push(topic),
  };
  return { master, client, register, port, records, gone, listener };
}

const seen = (records: readonly EncodedRecord[]) =>
  records.map(({ bytes, deviceId }) => [decodeRecord(bytes).value, deviceId]);

describe('topics over a client, with their devices', () => {
  it('[PM-43] names the device of the first record already, though it came before the answer', async () => {
    const { master, register, port, records, gone, listener } = await setup();
    const pad = await register('a');
    port.subscribe({ kind: 'glob', glob: '/pads/*' }, listener);
    // In the turns between the subscription and the list of components.
    for (let value = 1; value <= 12; value++) {
      await Promise.resolve();
      master.publish({ topic: '/pads/a', format: 'double', value });
    }
    master.publish({ topic: '/pads/a' });
    await settle();
    expect(records.length).toBeGreaterThan(0);
    expect(seen(records).at(-1)).toEqual([12, pad.id]);
    for (const { deviceId } of records) expect(deviceId).toBe(pad.id);
    expect(gone).toEqual(['/pads/a']);
  });

  it('holds the newest value of a topic, and every event, while it asks for devices', async () => {
    const { master, register, port, records, listener } = await setup();
    await register('a');
    port.subscribe({ kind: 'glob', glob: '/pads/*' }, listener);
    // In the turns between the subscription and the list of components.
    for (let value = 1; value <= 240; value++) {
      if (value % 20 === 1) await Promise.resolve();
      master.publish({ topic: '/pads/a', format: 'double', value });
      master.publish({ topic: '/pads/keys', format: 'keyEvent', value: { key: String(value) } });
    }
    await settle();
    const of = (topic: string) => records.filter((record) => record.topic === topic);
    const keys = of('/pads/keys').map(({ bytes }) => (decodeRecord(bytes).value as KeyEvent).key);
    expect(keys.length).toBeGreaterThan(40);
    expect(keys).toEqual(Array.from(keys, (_, i) => String(240 - keys.length + 1 + i)));
    // Records received during the request are merged to one value and all events; later ones are delivered one by one.
    expect(of('/pads/a').length).toBeLessThanOrEqual(keys.length - 19);
    expect(decodeRecord(of('/pads/a').at(-1)!.bytes).value).toBe(240);
  });

  it('asks nothing for single topics, and watches no longer than it is used', async () => {
    const { master, client, port, listener } = await setup();
    const before = master.requests.length;
    const one = port.subscribe({ kind: 'topic', topic: '/a' }, listener);
    await settle();
    expect(master.requests.length).toBe(before + 1);
    const many = port.subscribe({ kind: 'regex', source: '^/pads/' }, listener);
    await settle();
    expect(master.holds(client.id).topics).toContain('/info/device/new');
    one();
    many();
    many();
    await settle();
    expect(master.holds(client.id)).toMatchObject({ topics: [], regexes: [] });
  });

  it('refuses what it cannot select or publish, with a sentence', async () => {
    const { port, listener } = await setup();
    expect(() => port.subscribe({ kind: 'regex', source: '(' }, listener)).toThrow(
      'Expected a regular expression',
    );
    expect(port.publish('', new Uint8Array(), 0)).toContain('needs a topic');
    expect(port.publish('/ubii/x', new Uint8Array(), 0)).toContain('Only the master');
  });
});
