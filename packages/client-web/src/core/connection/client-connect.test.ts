import { ServiceError } from '@ubii/proto';
import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';
import { createMemoryIdentity } from './identity.ts';
import { LIBRARY_NAME } from './library-name.ts';

describe('client.connect()', () => {
  it('registers with what it is told, and asks for record lists [EX-1 EX-2]', async () => {
    const master = new FakeMaster();
    const { client } = createTestClient(master, {
      name: 'ada',
      description: 'a test',
      tags: ['x'],
    });
    await client.connect();
    expect(master.requests[0]).toMatchObject({
      topic: '/services/client/registration',
      client: {
        id: '',
        name: 'ada',
        description: 'a test',
        tags: ['x'],
        extension: { recordLists: true, library: LIBRARY_NAME, resumeToken: '' },
      },
    });
    expect(client.id).toBe('client-1');
  });

  it('goes from idle over connecting to connected', async () => {
    const { client, states, clock } = createTestClient(new FakeMaster());
    expect(client.state).toEqual({ status: 'idle' });
    await client.connect();
    expect(states).toEqual([
      { status: 'connecting', attempt: 1 },
      {
        status: 'connected',
        clientId: 'client-1',
        resumed: false,
        masterVersion: '1.2.3',
        sinceMs: clock.nowMs(),
      },
    ]);
  });

  it('connects once, however often it is asked', async () => {
    const master = new FakeMaster();
    const { client } = createTestClient(master);
    await Promise.all([client.connect(), client.connect()]);
    await client.connect();
    expect(master.clientIds).toEqual(['client-1']);
  });

  it('continues to try while the master is down', async () => {
    const master = new FakeMaster();
    master.isDown = true;
    const { client, clock, states } = createTestClient(master);
    const connected = client.connect();
    await clock.advance(60_000);
    expect(states.at(-1)).toMatchObject({ status: 'reconnecting', error: { reason: 'refused' } });
    master.isDown = false;
    await clock.advance(5_000);
    await connected;
    expect(client.state.status).toBe('connected');
  });

  it('says when it tries again', async () => {
    const master = new FakeMaster();
    master.isDown = true;
    const { client, clock, states } = createTestClient(master, {
      reconnect: { initialDelayMs: 100, factor: 2 },
    });
    const startMs = clock.nowMs();
    void client.connect();
    await clock.advance(600);
    expect(states.slice(1)).toMatchObject([
      { status: 'reconnecting', attempt: 2, nextAttemptMs: startMs + 200 },
      { status: 'reconnecting', attempt: 3, nextAttemptMs: startMs + 600 },
      { status: 'reconnecting', attempt: 4, nextAttemptMs: startMs + 1_400 },
    ]);
  });

  it('gives up when the policy says so', async () => {
    const master = new FakeMaster();
    master.isDown = true;
    const { client } = createTestClient(master, { reconnect: { giveUpAfterAttempts: 1 } });
    await expect(client.connect()).rejects.toMatchObject({ reason: 'refused' });
    expect(client.state).toMatchObject({ status: 'closed', error: { reason: 'refused' } });
  });

  it('can be asked again after it gave up', async () => {
    const master = new FakeMaster();
    master.isDown = true;
    const { client } = createTestClient(master, { reconnect: { giveUpAfterAttempts: 1 } });
    await expect(client.connect()).rejects.toThrow();
    master.isDown = false;
    await client.connect();
    expect(client.state.status).toBe('connected');
  });

  it('does not try again what can never succeed', async () => {
    const master = new FakeMaster();
    master.onRequest = () => new ServiceError('permission_denied', 'Not on this network');
    const { client } = createTestClient(master);
    await expect(client.connect()).rejects.toMatchObject({ reason: 'refused' });
    expect(client.state).toMatchObject({
      status: 'closed',
      error: { message: expect.stringContaining('Not on this network') as string },
    });
  });

  it('tries again what a limit forbids', async () => {
    const master = new FakeMaster();
    master.onRequest = () => new ServiceError('resource_exhausted', 'Too many clients');
    const { client, clock } = createTestClient(master);
    const connected = client.connect();
    await settle();
    expect(client.state.status).toBe('reconnecting');
    master.onRequest = undefined;
    await clock.advance(5_000);
    await connected;
  });

  it('does not wait forever for a master that keeps silent', async () => {
    const master = new FakeMaster();
    master.isSilent = true;
    const { client, clock } = createTestClient(master, { serviceTimeoutMs: 3_000 });
    void client.connect();
    await clock.advance(3_000);
    expect(client.state).toMatchObject({ status: 'reconnecting', error: { reason: 'timeout' } });
  });

  it('measures the round trip from the start', async () => {
    const { client, clock } = createTestClient(new FakeMaster());
    const seen: number[] = [];
    client.onRoundTrip(({ lastMs }) => seen.push(lastMs));
    expect(client.roundTrip).toBeUndefined();
    await client.connect();
    expect(client.roundTrip).toEqual({ lastMs: 0, p50Ms: 0, p95Ms: 0 });
    await clock.advance(4_000);
    expect(seen).toEqual([0, 0, 0]);
  });
});

describe('client.connect() with the identity of an earlier run', () => {
  it('ends what the earlier run left behind and comes back under its id [CL-3] [EX-7]', async () => {
    const master = new FakeMaster();
    const identity = createMemoryIdentity();
    const earlier = createTestClient(master, { identity });
    await earlier.client.connect();
    await earlier.client.subscribe({ glob: '**' }).ready;
    master.drop(1001);

    const { client, states } = createTestClient(master, { identity });
    await client.connect();
    expect(client.id).toBe(earlier.client.id);
    expect(states.at(-1)).toMatchObject({ status: 'connected', resumed: true });
    expect(master.holds(client.id).regexes).toEqual([]);
  });

  it('comes back under its id to a master that forgot it', async () => {
    const master = new FakeMaster();
    const identity = createMemoryIdentity({ clientId: 'client-9', resumeToken: 'key:client-9' });
    const { client } = createTestClient(master, { identity });
    await client.connect();
    expect(client.id).toBe('client-9');
  });

  it('gets another id when its token is worth nothing', async () => {
    const identity = createMemoryIdentity({ clientId: 'client-9', resumeToken: 'wrong' });
    const { client, states } = createTestClient(new FakeMaster(), { identity });
    await client.connect();
    expect(client.id).toBe('client-1');
    expect(states.at(-1)).toMatchObject({ resumed: false });
    expect(await identity.load()).toEqual({ clientId: 'client-1', resumeToken: 'key:client-1' });
  });
});

describe('client.rename()', () => {
  it('tells the master at once when connected', async () => {
    const master = new FakeMaster();
    const { client } = createTestClient(master);
    await client.connect();
    await client.rename('Ada Lovelace');
    expect(master.holds(client.id).name).toBe('Ada Lovelace');
    expect(client.name).toBe('Ada Lovelace');
    expect(client.state.status).toBe('connected');
  });

  it('tells the master when it comes back, though the master still knows the client', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master);
    await client.connect();
    master.stop();
    await settle();
    await client.rename('Ada Lovelace');
    master.isDown = false;
    await clock.advance(5_000);
    expect(master.holds(client.id).name).toBe('Ada Lovelace');
  });

  it('does not reject when the master cannot be reached, and tells it later', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master);
    await client.connect();
    master.isDown = true; // the socket stays
    await client.rename('Ada Lovelace');
    master.isDown = false;
    await clock.advance(2_000);
    expect(master.holds(client.id).name).toBe('Ada Lovelace');
    expect(client.state.status).toBe('connected');
  });

  it('is the name of the first registration when called before it', async () => {
    const master = new FakeMaster();
    const { client } = createTestClient(master);
    await client.rename('Ada Lovelace');
    await client.connect();
    expect(master.holds(client.id).name).toBe('Ada Lovelace');
  });
});
