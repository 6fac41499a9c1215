import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';
import { createMemoryIdentity } from './identity.ts';

describe('client.close()', () => {
  it('sends what waits before it deregisters [CL-16]', async () => {
    const master = new FakeMaster();
    const { client, clock, states } = createTestClient(master, { publishIntervalMs: 1_000 });
    await client.connect();
    client.publish('/a', 'double', 1);
    await clock.advance(0);
    client.publish('/a', 'double', 2);
    let publishedBefore: unknown[] = [];
    master.onRequest = ({ topic }) => {
      if (topic === '/services/client/deregistration') publishedBefore = [...master.published];
    };
    await client.close();
    expect(publishedBefore).toMatchObject([{ value: 1 }, { value: 2 }]);
    expect(master.clientIds).toEqual([]);
    expect(states.at(-1)).toEqual({ status: 'closed', error: undefined });
    expect(clock.timerCount).toBe(0);
  });

  it('can be called again, during and after', async () => {
    const master = new FakeMaster();
    const { client, states } = createTestClient(master);
    await client.connect();
    await Promise.all([client.close(), client.close()]);
    await client.close();
    expect(states.filter(({ status }) => status === 'closed')).toHaveLength(1);
    expect(master.requests.filter(({ topic }) => topic.endsWith('/deregistration'))).toHaveLength(
      1,
    );
  });

  it('closes a client that never connected', async () => {
    const { client } = createTestClient(new FakeMaster());
    await client.close();
    expect(client.state).toEqual({ status: 'closed', error: undefined });
  });

  it('rejects pending calls', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master);
    await client.connect();
    master.isSilent = true;
    const called = client.call('topicList').catch((error: unknown) => error);
    await settle();
    const closed = client.close();
    expect(await called).toMatchObject({ name: 'ConnectionError', reason: 'closed' });
    await clock.advance(10_000);
    await closed;
  });

  it('ends subscriptions, their loops and what waits for them', async () => {
    const master = new FakeMaster();
    const { client } = createTestClient(master);
    await client.connect();
    const accepted = client.subscribe('/a');
    await accepted.ready;
    const loop = (async () => {
      const values: unknown[] = [];
      for await (const { value } of accepted) values.push(value);
      return values;
    })();
    master.publish({ topic: '/a', format: 'double', value: 1 });
    await settle();
    await client.close();
    expect(await loop).toEqual([1]);
    await accepted.close();
  });

  it('rejects the ready of a subscription that was never accepted', async () => {
    const { client } = createTestClient(new FakeMaster());
    const { ready } = client.subscribe('/a');
    void client.connect();
    await client.close();
    await expect(ready).rejects.toMatchObject({ reason: 'closed' });
  });

  it('does not wait long for a master that keeps silent', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master);
    await client.connect();
    master.isSilent = true;
    const closed = client.close();
    expect(client.state.status).toBe('closed');
    await clock.advance(4_000);
    await closed;
    expect(clock.timerCount).toBe(0);
  });

  it('stops a client that is waiting to reconnect', async () => {
    const master = new FakeMaster();
    const { client, clock, states } = createTestClient(master);
    await client.connect();
    master.stop();
    await clock.advance(1_000);
    const requests = master.requests.length;
    await client.close();
    await clock.advance(60_000);
    expect(states.at(-1)).toEqual({ status: 'closed', error: undefined });
    expect(master.requests).toHaveLength(requests);
    expect(clock.timerCount).toBe(0);
  });

  it('rejects a connect() that is under way, and leaves no client behind', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master);
    const connected = client.connect().catch((error: unknown) => error);
    await Promise.resolve();
    await client.close();
    expect(await connected).toMatchObject({ name: 'ConnectionError', reason: 'closed' });
    await clock.advance(60_000);
    expect(master.clientIds).toEqual([]);
    expect(client.state.status).toBe('closed');
  });

  it.each([1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 40])(
    'leaves no client behind when it comes %i turns into an attempt',
    async (turns) => {
      const master = new FakeMaster();
      const { client, clock } = createTestClient(master);
      client.subscribe('/a').onRecord(() => undefined);
      client.connect().catch(() => undefined);
      for (let i = 0; i < turns; i++) await Promise.resolve();
      await client.close();
      await settle();
      expect(master.clientIds).toEqual([]);
      expect(clock.timerCount).toBe(0);
      expect(client.state).toEqual({ status: 'closed', error: undefined });
    },
  );

  it('forgets the identity, and connects as a new client afterwards', async () => {
    const master = new FakeMaster();
    const identity = createMemoryIdentity();
    const { client } = createTestClient(master, { identity });
    await client.connect();
    await client.close();
    expect(await identity.load()).toBeUndefined();
    await client.connect();
    expect(client.id).toBe('client-2');
    expect(master.clientIds).toEqual(['client-2']);
  });
});

describe('client.leave()', () => {
  it('tells the master at once, after what was published, and comes back as the same client [EX-55]', async () => {
    const master = new FakeMaster();
    const { client, clock, states } = createTestClient(master, { publishIntervalMs: 1_000 });
    const values: unknown[] = [];
    client.subscribe('/a').onRecord(({ value }) => values.push(value));
    await client.connect();
    const registered = client.registerDevice({ name: 'pad', components: [] });
    await settle();
    await registered;
    client.publish('/b', 'double', 1);
    client.leave();
    expect(client.state).toEqual({ status: 'closed', error: undefined });
    await settle();
    expect(master.published).toMatchObject([{ topic: '/b', value: 1 }]);
    expect(master.farewells).toEqual([{ clientId: 'client-1', code: 4000 }]);
    expect(master.clientIds).toEqual([]);
    expect(clock.timerCount).toBe(0);

    await client.connect();
    expect(states.at(-1)).toMatchObject({ clientId: 'client-1', resumed: true });
    expect(master.holds('client-1').devices).toMatchObject([{ name: 'pad' }]);
    master.publish({ topic: '/a', format: 'double', value: 2 });
    await settle();
    expect(values).toEqual([2]);
  });

  it('says so on a socket, too, that has opened and is not answered yet', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master);
    await client.connect();
    master.drop();
    const open = master.openConnection.bind(master);
    master.openConnection = (query, peer) => {
      const connection = open(query, peer);
      return connection && { ...connection, handleText: () => undefined };
    };
    await clock.advance(500);
    expect(client.state.status).toBe('reconnecting');
    client.leave();
    await settle();
    expect(master.farewells).toHaveLength(1);
    expect(master.clientIds).toEqual([]);
  });

  it('stops a client that is waiting to reconnect, and does nothing to one that is closed', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master);
    client.leave();
    await client.connect();
    master.stop();
    await settle();
    client.leave();
    client.leave();
    await clock.advance(60_000);
    expect(client.state).toEqual({ status: 'closed', error: undefined });
    expect(clock.timerCount).toBe(0);
  });
});
