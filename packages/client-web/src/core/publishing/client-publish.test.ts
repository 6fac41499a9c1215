import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';

async function setup(publishIntervalMs = 15) {
  const master = new FakeMaster();
  const all = createTestClient(master, { publishIntervalMs });
  await all.client.connect();
  return { master, ...all };
}

describe('client.publish()', () => {
  it('sends value, timestamp and client id', async () => {
    const { master, client, clock } = await setup();
    client.publish('/a', 'vector2', { x: 1, y: 0 });
    client.publish('/b', 'double', 0, { timestampMs: 1_600_000_000_123 });
    await clock.advance(0);
    expect(master.published).toEqual([
      {
        topic: '/a',
        format: 'vector2',
        value: { x: 1, y: 0 },
        timestampMs: clock.nowMs(),
        clientId: client.id,
      },
      {
        topic: '/b',
        format: 'double',
        value: 0,
        timestampMs: 1_600_000_000_123,
        clientId: client.id,
      },
    ]);
  });

  it('collects records into frames, in order', async () => {
    const { master, client, clock } = await setup(15);
    client.publish('/a', 'int32', 1);
    await clock.advance(0);
    for (const n of [2, 3, 4]) client.publish('/a', 'int32', n);
    client.setPublishIntervalMs(50);
    await clock.advance(50);
    expect(master.published.map(({ value }) => value)).toEqual([1, 2, 3, 4]);
    expect(master.frameSizes).toEqual([1, 3]);
  });

  it('sends at once when told to', async () => {
    const { master, client } = await setup(1_000);
    client.publish('/a', 'int32', 1, { immediate: true });
    client.publish('/a', 'int32', 2, { immediate: true });
    await settle();
    expect(master.frameSizes).toEqual([1, 1]);
  });

  it('takes the value as it is at the call', async () => {
    const { master, client, clock } = await setup();
    const value = { x: 1, y: 1 };
    client.publish('/a', 'vector2', value);
    value.x = 2;
    await clock.advance(15);
    expect(master.published[0]?.value).toEqual({ x: 1, y: 1 });
  });

  it('counts what goes out and comes in', async () => {
    const { client, clock } = await setup();
    client.subscribe('/a').onRecord(() => undefined);
    await settle();
    client.publish('/a', 'double', 1);
    await clock.advance(15);
    expect(client.counters).toMatchObject({
      recordsIn: 1,
      recordsOut: 1,
      recordsDropped: 0,
      decodeErrors: 0,
    });
    expect(client.counters.bytesIn).toBeGreaterThan(0);
    expect(client.counters.bytesOut).toBeGreaterThan(0);
  });

  it('ends a topic at once, after what was published before [TD-48]', async () => {
    const { master, client } = await setup(1_000);
    client.publish('/a', 'int32', 1);
    client.endTopic('/a');
    await settle();
    expect(master.frameSizes).toEqual([2]);
    expect(() => client.endTopic('')).toThrow(TypeError);
  });

  it('says how many bytes have not left yet', async () => {
    const { client, clock } = await setup(1_000);
    client.publish('/a', 'int32', 1, { immediate: true });
    await settle();
    expect(client.bufferedBytes).toBe(0);
    client.publish('/a', 'string', 'x'.repeat(1000));
    expect(client.bufferedBytes).toBeGreaterThan(1000);
    await clock.advance(1_000);
    expect(client.bufferedBytes).toBe(0);
  });

  it('refuses at once what cannot be right', async () => {
    const { client } = await setup();
    expect(() => client.publish('', 'double', 1)).toThrow(TypeError);
    expect(() => client.publish('/a', 'double', 1, { keepSeconds: -1 })).toThrow(RangeError);
    // @ts-expect-error a format that does not exist
    expect(() => client.publish('/a', 'vector9', { x: 1 })).toThrow(TypeError);
    // @ts-expect-error a member of another type
    expect(() => client.publish('/a', 'vector2', { x: '1', y: 2 })).toThrow(TypeError);
    // @ts-expect-error a number is no text
    expect(() => client.publish('/a', 'string', 1)).toThrow(TypeError);
  });

  it('tells what the master refuses [TD-17]', async () => {
    const { master, problems } = await setup();
    const { encodeErrorFrame } = await import('@ubii/proto/wire');
    master.sendBytes(
      encodeErrorFrame({
        title: 'Not allowed',
        message: 'The topic /info/x belongs to the master',
        stack: '',
        code: 'permission_denied',
      }),
    );
    await settle();
    expect(problems).toMatchObject([{ name: 'ServiceError', code: 'permission_denied' }]);
  });
});

describe('a client that is sent garbage', () => {
  it('counts and tells it, and loses nothing else', async () => {
    const { master, client, problems } = await setup();
    const values: unknown[] = [];
    client.subscribe('/a').onRecord(({ value }) => values.push(value));
    await settle();
    master.sendBytes(new Uint8Array([0xff, 0xff, 0xff]));
    master.sendBytes(new Uint8Array());
    master.sendText('hello');
    master.sendText('');
    master.publish({ topic: '/a', format: 'double', value: 1 });
    await settle();
    expect(values).toEqual([1]);
    expect(client.state.status).toBe('connected');
    expect(client.counters.decodeErrors).toBe(problems.length);
    expect(problems.map(({ name }) => name)).toEqual(['DecodeError', 'DecodeError', 'DecodeError']);
  });

  it('survives thousands of random frames', async () => {
    const { master, client, problems } = await setup();
    let seed = 1;
    const random = () => (seed = (seed * 48_271) % 2_147_483_647) / 2_147_483_647;
    for (let i = 0; i < 3_000; i++) {
      master.sendBytes(
        Uint8Array.from({ length: Math.floor(random() * 60) }, () => Math.floor(random() * 256)),
      );
    }
    await settle();
    expect(client.state.status).toBe('connected');
    expect(problems.length).toBeGreaterThan(1_000);
  });
});
