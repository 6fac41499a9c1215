import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';

async function setup() {
  const master = new FakeMaster({ isOriginal: true });
  const all = createTestClient(master);
  await all.client.connect();
  await all.clock.advance(10_000);
  return { master, ...all };
}

describe('a client of an original master [EX-1]', () => {
  it('connects without token and without a PING of its own', async () => {
    const { client, states } = await setup();
    expect(states.at(-1)).toMatchObject({ status: 'connected', masterVersion: undefined });
    expect(client.roundTrip).toBeUndefined();
  });

  it('answers PING', async () => {
    const { master } = await setup();
    const texts: string[] = [];
    const open = master.openConnection.bind(master);
    master.openConnection = (query, peer) => {
      expect(query.resumeToken).toBeUndefined();
      const connection = open(query, peer)!;
      return { ...connection, handleText: (text) => texts.push(text) };
    };
    const { client } = createTestClient(master, { name: 'ben' });
    await client.connect();
    master.sendText('PING');
    await settle();
    expect(texts).toEqual(['PONG']);
  });

  it('publishes and receives', async () => {
    const { client, clock } = await setup();
    const values: unknown[] = [];
    client.subscribe('/a').onRecord(({ value }) => values.push(value));
    await settle();
    client.publish('/a', 'double', 1);
    await clock.advance(20);
    expect(values).toEqual([1]);
  });

  it('delivers once what the master sends for each subscription', async () => {
    const { master, client } = await setup();
    const values: unknown[][] = [[], [], []];
    client.subscribe('/a').onRecord(({ value }) => values[0]!.push(value));
    client.subscribe({ glob: '/*' }).onRecord(({ value }) => values[1]!.push(value));
    client.subscribe({ regex: 'a' }).onRecord(({ value }) => values[2]!.push(value));
    await settle();
    for (const value of [1, 1, 2]) master.publish({ topic: '/a', format: 'double', value });
    await settle();
    expect(values).toEqual([
      [1, 1, 2],
      [1, 1, 2],
      [1, 1, 2],
    ]);
  });

  it('keeps its id over a dropped socket while the master still knows it', async () => {
    const { master, client, clock, states } = await setup();
    master.drop();
    await clock.advance(1_000);
    expect(states.at(-1)).toMatchObject({
      status: 'connected',
      clientId: 'client-1',
      resumed: true,
    });
    expect(client.id).toBe('client-1');
  });

  it('comes back with another id after a restart, with devices and subscriptions, and says so', async () => {
    const { master, client, clock, states } = await setup();
    const changes: unknown[] = [];
    client.onIdentityChange((change) => changes.push(change));
    const values: unknown[] = [];
    client.subscribe('/a').onRecord(({ value }) => values.push(value));
    const device = await client.registerDevice({
      name: 'mouse',
      components: [{ name: 'position', format: 'vector2' }],
    });
    master.restart();
    await clock.advance(5_000);
    expect(states.at(-1)).toMatchObject({ status: 'connected', resumed: false });
    expect(changes).toEqual([{ previousId: 'client-1', clientId: client.id }]);
    expect(device.component('position').topic).toBe(`/${client.id}/mouse/position`);
    master.publish({ topic: '/a', format: 'double', value: 1 });
    await settle();
    expect(values).toEqual([1]);
  });

  it('subscribes to the topics of a component profile itself', async () => {
    const { master, client, clock } = await setup();
    const { client: ben } = createTestClient(master, { name: 'ben', clock });
    await ben.connect();
    const phone = await ben.registerDevice({
      name: 'phone',
      components: [{ name: 'touch', format: 'double' }],
    });
    const values: unknown[] = [];
    const subscription = client.subscribe({ component: { name: 'touch' } });
    subscription.onRecord(({ value }) => values.push(value));
    await subscription.ready;
    await settle();
    phone.component('touch').publish(1);
    await clock.advance(20);
    expect(values).toEqual([1]);
    await subscription.close();
    await settle();
    expect(master.holds(client.id).topics).toEqual([]);
  });
});
