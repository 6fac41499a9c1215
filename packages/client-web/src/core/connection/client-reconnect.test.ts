import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';

async function setup(options: Parameters<typeof createTestClient>[1] = {}) {
  const master = new FakeMaster();
  const all = createTestClient(master, options);
  await all.client.connect();
  await all.clock.advance(10_000); // the link has held
  all.states.length = 0;
  return { master, ...all };
}

const SILENT_CONNECTION = {
  handleBinary: () => undefined,
  handleText: () => undefined,
  handleClose: () => undefined,
};

function registrations(master: FakeMaster): number {
  return master.requests.filter(({ topic }) => topic === '/services/client/registration').length;
}

describe('a client whose socket drops [EX-5]', () => {
  it('opens a new one with the same id, without registering again', async () => {
    const { master, client, clock, states } = await setup();
    master.drop();
    await clock.advance(250);
    expect(states).toMatchObject([
      { status: 'reconnecting', attempt: 1, error: { reason: 'closed' } },
      { status: 'connected', clientId: 'client-1', resumed: true },
    ]);
    expect(registrations(master)).toBe(1);
    expect(client.id).toBe('client-1');
  });

  it('registers again with id and token when the master does not know it any more (4004)', async () => {
    const { master, clock, states } = await setup();
    master.restart();
    await clock.advance(250);
    expect(states.at(-1)).toMatchObject({
      status: 'connected',
      clientId: 'client-1',
      resumed: true,
    });
    expect(registrations(master)).toBe(2);
    expect(master.requests.findLast(({ client }) => client !== undefined)).toMatchObject({
      client: { id: 'client-1', extension: { resumeToken: 'key:client-1' } },
    });
  });

  it('registers again after another client deregistered it (1000)', async () => {
    const { master, client, clock } = await setup();
    const subscription = client.subscribe('/a');
    await subscription.ready;
    master.forget(client.id);
    master.drop(1000);
    await clock.advance(0);
    expect(client.state).toMatchObject({ status: 'connected', clientId: 'client-1' });
    expect(master.holds('client-1').topics).toEqual(['/a']);
  });

  it('registers as a new client when its token is worth nothing (4003)', async () => {
    const { master, client, clock, states } = await setup();
    const changes: unknown[] = [];
    client.onIdentityChange((change) => changes.push(change));
    master.restart({ hasNewKey: true });
    await clock.advance(250);
    expect(states.at(-1)).toMatchObject({
      status: 'connected',
      clientId: 'client-2',
      resumed: false,
    });
    expect(changes).toEqual([{ previousId: 'client-1', clientId: 'client-2' }]);
    expect(client.id).toBe('client-2');
  });

  it('stops permanently when another socket took its identity (4001)', async () => {
    const { master, client, clock, states } = await setup();
    master.isSilent = true;
    const held = client.call('topicList').catch((error: unknown) => error);
    master.drop(4001);
    await settle();
    expect(states).toMatchObject([{ status: 'closed', error: { reason: 'superseded' } }]);
    expect(await held).toMatchObject({ reason: 'superseded' });
    await clock.advance(600_000);
    expect(states).toHaveLength(1);
    expect(clock.timerCount).toBe(0);
  });

  it('stops after an admin disconnected it (4010), with the name and the reason [EX-30]', async () => {
    const { master, clock, states } = await setup();
    master.drop(4010, 'by Mara: too loud');
    await settle();
    expect(states).toMatchObject([
      {
        status: 'closed',
        error: {
          reason: 'disconnected',
          message: 'This client was disconnected by Mara: too loud',
        },
      },
    ]);
    await clock.advance(600_000);
    expect(states).toHaveLength(1);
    expect(clock.timerCount).toBe(0);
  });

  it('registers again when told to connect again after 4010', async () => {
    const { master, client } = await setup();
    master.forget('client-1');
    master.drop(4010, '');
    await settle();
    await client.connect();
    expect(client.id).toBe('client-1');
  });

  it('takes the identity back when told to connect again after 4001', async () => {
    const { master, client } = await setup();
    const records: unknown[] = [];
    client.subscribe('/a').onRecord(({ value }) => records.push(value));
    master.drop(4001);
    await settle();
    await client.connect();
    expect(client.id).toBe('client-1');
    master.publish({ topic: '/a', format: 'double', value: 1 });
    await settle();
    expect(records).toEqual([1]);
  });

  it('leaves the identity to the other when closed after 4001', async () => {
    const { master, client } = await setup();
    master.drop(4001);
    await settle();
    await client.close();
    expect(master.clientIds).toEqual(['client-1']);
  });

  it.each([1001, 1006, 1009, 1011, 4008, 4009, 4013])('backs off after code %i', async (code) => {
    const { master, client, clock, states } = await setup();
    master.drop(code);
    await settle();
    expect(states).toMatchObject([
      { status: 'reconnecting', attempt: 1, nextAttemptMs: clock.nowMs() + 250 },
    ]);
    await clock.advance(250);
    expect(client.state.status).toBe('connected');
  });

  it('backs off further from a master that throws it out again and again', async () => {
    const { master, clock, states } = await setup({
      reconnect: { initialDelayMs: 100, factor: 2, maxDelayMs: 1_000 },
    });
    const delaysMs: number[] = [];
    for (let i = 0; i < 6; i++) {
      master.drop(4008);
      await settle();
      const state = states.at(-1);
      if (state?.status !== 'reconnecting') throw new Error('expected reconnecting');
      expect(state.attempt).toBe(1);
      delaysMs.push(state.nextAttemptMs - clock.nowMs());
      await clock.advance(delaysMs.at(-1)!);
      expect(states.at(-1)?.status).toBe('connected');
    }
    expect(delaysMs).toEqual([100, 200, 400, 800, 1_000, 1_000]);
  });

  it('retries without a delay only once in one outage', async () => {
    const { master, clock, client } = await setup();
    // Registration succeeds, and the socket is refused anyway.
    const refuse = master.openConnection.bind(master);
    let refusals = 0;
    master.openConnection = (query, peer) => {
      refusals += 1;
      peer.close(4004, '');
      return undefined;
    };
    master.drop();
    await clock.advance(250);
    expect(refusals).toBe(2);
    expect(client.state).toMatchObject({ status: 'reconnecting', attempt: 3 });
    master.openConnection = refuse;
    await clock.advance(5_000);
    expect(client.state.status).toBe('connected');
  });

  it('gives up when the policy says so, and says why', async () => {
    const { master, client, clock } = await setup({ reconnect: { giveUpAfterAttempts: 3 } });
    master.stop();
    await settle();
    const later = client.connect().catch((error: unknown) => error);
    await clock.advance(60_000);
    expect(client.state).toMatchObject({ status: 'closed', error: { reason: 'closed' } });
    expect(await later).toMatchObject({ name: 'ConnectionError' });
    expect(clock.timerCount).toBe(0);
  });

  it('tries at once when told to', async () => {
    const { master, client, clock } = await setup({ reconnect: { initialDelayMs: 5_000 } });
    master.drop();
    await settle();
    client.retryNow();
    await settle();
    expect(client.state.status).toBe('connected');
    await clock.advance(10_000);
    expect(client.state.status).toBe('connected');
  });

  it('gives an attempt up that hangs when it is told to try, but not a fresh one', async () => {
    const { master, client, clock } = await setup();
    const open = master.openConnection.bind(master);
    let opened = 0;
    master.openConnection = (query, peer) => {
      opened += 1;
      return opened > 1 ? open(query, peer) : SILENT_CONNECTION;
    };
    master.drop();
    await clock.advance(500);
    client.retryNow();
    await clock.advance(0);
    expect(opened).toBe(1);
    await clock.advance(1_000);
    client.retryNow();
    await clock.advance(0);
    expect(opened).toBe(2);
    expect(client.state).toMatchObject({ status: 'connected', clientId: 'client-1' });
  });

  it('makes sure of its link when the machine slept, and is back within 2 s of waking [CL-41] [CL-42]', async () => {
    const { master, client, clock } = await setup();
    master.isSilent = true;
    clock.setWall(3_600_000);
    await clock.advance(1_500);
    expect(client.state).toMatchObject({ status: 'reconnecting', error: { reason: 'timeout' } });
    master.isSilent = false;
    await clock.advance(500);
    expect(client.state).toMatchObject({ status: 'connected', clientId: 'client-1' });
  });

  it('stays on a good link when the machine slept', async () => {
    const { client, clock, states } = await setup();
    await clock.sleep(3_600_000);
    await clock.advance(10_000);
    expect(client.state.status).toBe('connected');
    expect(states).toEqual([]);
  });

  it('finds a master that was away for long within 2 s [CL-43]', async () => {
    const { master, client, clock } = await setup();
    master.stop();
    await clock.advance(600_000);
    master.restart();
    await clock.advance(2_000);
    expect(client.state).toMatchObject({ status: 'connected', clientId: 'client-1' });
  });

  it('does not wait long for a socket that does not open, but longer each time [CL-43]', async () => {
    const { master, client, clock } = await setup();
    const open = master.openConnection.bind(master);
    const openedMs: number[] = [];
    master.openConnection = () => {
      openedMs.push(clock.monotonicMs());
      return SILENT_CONNECTION;
    };
    const startMs = clock.monotonicMs();
    master.drop();
    await clock.advance(20_000);
    const waits = openedMs.map((atMs, index) =>
      Math.floor(atMs - (openedMs[index - 1] ?? startMs)),
    );
    expect(waits.slice(0, 4)).toEqual([250, 2_425, 4_722, 9_228]);
    // The network is back: it counts from the beginning, and what was begun before is given up.
    master.openConnection = open;
    await clock.advance(1_000);
    client.retryNow();
    await clock.advance(0);
    expect(client.state).toMatchObject({ status: 'connected', clientId: 'client-1' });
  });

  it('freshens the connections of services when the link fell silent, not when it was closed [CL-43]', async () => {
    const { master, clock } = await setup();
    const asked = () =>
      master.requests.filter(({ topic }) => topic.endsWith('/server_configuration'));
    master.drop();
    await clock.advance(1_000);
    expect(asked()).toHaveLength(0);
    master.isSilent = true;
    await clock.advance(8_000);
    master.isSilent = false;
    await clock.advance(5_000);
    expect(asked()).toHaveLength(6);
  });

  it('comes back by its socket while services hang on connections of the network before [CL-43]', async () => {
    const master = new FakeMaster();
    master.credential = 'credential';
    const { client, clock } = createTestClient(master);
    expect(client.authorization).toBeUndefined();
    await client.connect();
    expect(client.authorization).toBe('Bearer credential');
    await clock.advance(10_000);
    const open = master.openConnection.bind(master);
    // A socket that is refused silently: services are asked why. [AC-27]
    master.openConnection = () => undefined;
    master.handleServiceRequest = () => new Promise(() => undefined);
    master.drop();
    await clock.advance(1_000);
    master.openConnection = open;
    await clock.advance(3_000);
    expect(client.state).toMatchObject({ status: 'connected', clientId: 'client-1' });
    expect(registrations(master)).toBe(1);

    // Told that the network is back, it asks no services first.
    master.openConnection = () => undefined;
    master.drop();
    await clock.advance(2_000);
    expect(client.state.status).toBe('reconnecting');
    master.openConnection = open;
    client.retryNow();
    await clock.advance(0);
    expect(client.state.status).toBe('connected');
  });

  it('notices a master that fell silent', async () => {
    const { master, client, clock } = await setup();
    master.isSilent = true;
    await clock.advance(8_000);
    expect(client.state).toMatchObject({ status: 'reconnecting', error: { reason: 'timeout' } });
    master.isSilent = false;
    await clock.advance(15_000);
    expect(client.state).toMatchObject({ status: 'connected', clientId: 'client-1' });
  });

  it('comes back to another master at the same place, which knows nothing of it', async () => {
    const { master, client, clock } = await setup();
    master.stop();
    await clock.advance(3_000);
    master.restart({ hasNewKey: true });
    await clock.advance(6_000);
    expect(client.state).toMatchObject({ status: 'connected', clientId: 'client-2' });
  });
});

describe('a client whose link drops while it connects', () => {
  it('tries again when the socket drops before the master answered on it', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master);
    const open = master.openConnection.bind(master);
    let opened = 0;
    master.openConnection = (query, peer) => {
      opened += 1;
      if (opened > 1) return open(query, peer);
      peer.close(1006, '');
      return undefined;
    };
    const connected = client.connect();
    await clock.advance(1_000);
    await connected;
    expect(opened).toBe(2);
    expect(master.clientIds).toEqual(['client-1']);
  });

  it('tries again when the socket drops while subscriptions are being restored', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master);
    const subscription = client.subscribe('/a');
    let drops = 0;
    master.onRequest = ({ topicSubscription }) => {
      if (topicSubscription === undefined || drops > 0) return;
      drops += 1;
      master.drop();
    };
    const connected = client.connect();
    await clock.advance(1_000);
    await connected;
    await subscription.ready;
    expect(drops).toBe(1);
    expect(master.holds(client.id).topics).toEqual(['/a']);
  });

  it('is not superseded by its own second socket', async () => {
    const { master, client, clock, states } = await setup();
    master.isSilent = true; // the first socket stays open at the master
    await clock.advance(8_000);
    master.isSilent = false;
    await clock.advance(15_000);
    expect(client.state.status).toBe('connected');
    expect(states.every(({ status }) => status !== 'closed')).toBe(true);
  });
});

describe('a client that is away', () => {
  it('publishes the newest value of each topic when it comes back', async () => {
    const { master, client, clock } = await setup();
    master.stop();
    await settle();
    client.publish('/a', 'double', 1);
    client.publish('/a', 'double', 2);
    client.publish('/b', 'bool', true);
    await clock.advance(1_000);
    expect(client.counters.recordsDropped).toBe(1);
    master.isDown = false;
    await clock.advance(5_000);
    expect(master.published.map(({ topic, value }) => [topic, value])).toEqual([
      ['/a', 2],
      ['/b', true],
    ]);
  });

  it('keeps values published before the first connection', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master);
    client.publish('/a', 'double', 1);
    await clock.advance(100);
    await client.connect();
    await settle();
    expect(master.published).toMatchObject([{ topic: '/a', value: 1 }]);
  });

  it('subscribes when it comes back, and unsubscribes what was closed meanwhile', async () => {
    const { master, client, clock } = await setup();
    const closedAway = client.subscribe('/closed');
    const kept = client.subscribe('/kept');
    await Promise.all([closedAway.ready, kept.ready]);
    master.stop();
    await settle();
    const madeAway = client.subscribe({ glob: '/away/*' });
    await closedAway.close();
    master.isDown = false;
    await clock.advance(5_000);
    await madeAway.ready;
    expect(master.holds(client.id)).toMatchObject({
      topics: ['/kept'],
      regexes: ['^/away/[^/]*$'],
    });
  });

  it('restores all subscriptions at a master that lost them', async () => {
    const { master, client, clock } = await setup();
    const values: unknown[] = [];
    client.subscribe('/a').onRecord(({ value }) => values.push(value));
    client.subscribe({ regex: '^/b' }).onRecord(({ value }) => values.push(value));
    await settle();
    master.restart();
    await clock.advance(5_000);
    master.publish({ topic: '/a', format: 'double', value: 1 });
    master.publish({ topic: '/b/x', format: 'double', value: 2 });
    await settle();
    expect(values).toEqual([1, 2]);
  });

  it('gets the value that was published meanwhile', async () => {
    const { master, client, clock } = await setup();
    const values: unknown[] = [];
    client.subscribe('/a').onRecord(({ value }) => values.push(value));
    await settle();
    master.drop();
    master.publish({ topic: '/a', format: 'double', value: 1 });
    await clock.advance(5_000);
    expect(values).toEqual([1]);
  });

  it('calls services when it is back, if that is in time', async () => {
    const { master, client, clock } = await setup({ serviceTimeoutMs: 10_000 });
    master.stop();
    await settle();
    const called = client.call('topicList');
    await clock.advance(2_000);
    master.isDown = false;
    await clock.advance(5_000);
    expect((await called).elements).toEqual([]);
  });

  it('rejects calls that waited too long', async () => {
    const { master, client, clock } = await setup({ serviceTimeoutMs: 3_000 });
    master.stop();
    await settle();
    const called = client.call('topicList').catch((error: unknown) => error);
    await clock.advance(3_000);
    expect(await called).toMatchObject({ name: 'ConnectionError', reason: 'timeout' });
  });

  it('rejects calls at once when nothing is being done about it', async () => {
    const { client } = createTestClient(new FakeMaster());
    await expect(client.call('topicList')).rejects.toMatchObject({ reason: 'closed' });
  });
});
