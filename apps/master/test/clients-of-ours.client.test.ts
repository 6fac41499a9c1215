import { ClientState } from '@ubii/proto';
import type { TopicRecord } from '@ubii/proto';
import { createMemoryIdentity } from '@ubii/client-web/node';
import type { Subscription, UbiiClient } from '@ubii/client-web/node';
import { describe, expect, it } from 'vitest';
import { RecordingConnection } from '../src/testing/index.ts';
import { ClientWorld } from './client-world.ts';
import { TRUSTED_CALLER } from '../src/index.ts';

async function setup(...names: string[]) {
  const world = new ClientWorld();
  const clients = await Promise.all(names.map((name) => world.connect(name)));
  return { world, clients };
}

/** Ada publishes, Ben watches. */
async function setupTwo() {
  const { world, clients } = await setup('ada', 'ben');
  const [ada, ben] = clients;
  if (ada === undefined || ben === undefined) throw new Error('two were asked for');
  return { world, ada, ben };
}

function collect(subscription: Subscription): TopicRecord[] {
  const records: TopicRecord[] = [];
  subscription.onRecord((record) => records.push(record));
  return records;
}

const values = (records: readonly TopicRecord[]): unknown[] => records.map(({ value }) => value);

const mouse = {
  name: 'mouse',
  components: [{ name: 'position', format: 'vector2', tags: ['pointer'] }],
} as const;

async function stateOf(world: ClientWorld, client: UbiiClient): Promise<ClientState | undefined> {
  const { clientList } = await world.test.call({ topic: '/services/client/get_list' });
  return clientList?.elements.find(({ id }) => id === client.id)?.state;
}

describe('two clients of ours', () => {
  it('exchange records, each of which comes once [TD-14]', async () => {
    const { world, ada, ben } = await setupTwo();
    const byTopic = collect(ben.client.subscribe('/a/x'));
    const byGlob = collect(ben.client.subscribe({ glob: '/a/*' }));
    const own = collect(ada.client.subscribe({ regex: '^/a' }));
    await world.pass(0);
    for (let i = 0; i < 100; i++) ada.client.publish('/a/x', 'int32', i);
    await world.pass(50);
    const expected = Array.from({ length: 100 }, (_, i) => i);
    expect(values(byTopic)).toEqual(expected);
    expect(values(byGlob)).toEqual(expected);
    expect(values(own)).toEqual(expected);
    expect(ben.client.counters.recordsIn).toBe(100);
  });

  it('get the retained records of topics and of patterns [TD-24]', async () => {
    const { world, ada, ben } = await setupTwo();
    ada.client.publish('/a/x', 'int32', 1);
    ada.client.publish('/a/y', 'int32', 2);
    await world.pass(50);
    const byTopic = collect(ben.client.subscribe('/a/x'));
    const byGlob = collect(ben.client.subscribe({ glob: '/a/*' }));
    await world.pass(50);
    expect(values(byTopic)).toContain(1);
    expect(new Set(values(byGlob))).toEqual(new Set([1, 2]));
  });

  it('see each other come, change their name and go [CL-31]', async () => {
    const { world, ada, ben } = await setupTwo();
    const seen = collect(ben.client.subscribe(`/ubii/client/${ada.client.id}`));
    await world.pass(0);
    await ada.client.rename('Ada Lovelace');
    await world.pass(0);
    const closed = ada.client.close();
    await world.pass(0);
    await closed;
    await world.pass(0);
    expect(
      seen.map(({ value }) => {
        const { name, state } = value as { name: string; state: number };
        return `${name} ${state}`;
      }),
    ).toEqual(['ada 0', 'Ada Lovelace 0', `Ada Lovelace ${ClientState.UNAVAILABLE}`]);
  });

  it('find each other by component profile, devices that come later as well [TD-27]', async () => {
    const { world, ada, ben } = await setupTwo();
    const pointers = collect(ben.client.subscribe({ component: { tags: ['pointer'] } }));
    await world.pass(0);
    const device = await ada.client.registerDevice(mouse);
    device.component('position').publish({ x: 1, y: 2 });
    ada.client.publish('/other', 'double', 1);
    await world.pass(50);
    expect(pointers).toMatchObject([
      { topic: `/${ada.client.id}/mouse/position`, value: { x: 1, y: 2 } },
    ]);
    await device.close();
    const again = await ada.client.registerDevice({ ...mouse, name: 'pen' });
    again.component('position').publish({ x: 3, y: 4 });
    await world.pass(50);
    expect(pointers.at(-1)).toMatchObject({ topic: `/${ada.client.id}/pen/position` });
  });

  it('are told what the master refuses [TD-16] [TD-21]', async () => {
    const { world, ada } = await setupTwo();
    ada.client.publish('/info/mine', 'double', 1);
    await world.pass(50);
    expect(ada.problems).toMatchObject([{ name: 'ServiceError', code: 'permission_denied' }]);
    expect(ada.client.state.status).toBe('connected');
  });

  it('receive no more than the rate they asked for, and the newest in the end [TD-28]', async () => {
    const { world, ada, ben } = await setupTwo();
    const records = collect(ben.client.subscribe('/a', { maxRateHz: 2 }));
    await world.pass(0);
    for (let i = 1; i <= 20; i++) {
      ada.client.publish('/a', 'int32', i);
      await world.pass(50);
    }
    await world.pass(1_000);
    expect(records.length).toBeLessThanOrEqual(4);
    expect(records.at(-1)?.value).toBe(20);
  });
});

describe('a client of ours whose link drops', () => {
  it('comes back as itself; others see it away and back, and its device stands [EX-5]', async () => {
    const { world, ada, ben } = await setupTwo();
    await ada.client.registerDevice(mouse);
    const deleted = collect(ben.client.subscribe('/info/device/delete'));
    const { id } = ada.client;
    await world.drop();
    expect(await stateOf(world, ada.client)).toBe(ClientState.INACTIVE);
    await world.pass(1_000);
    expect(ada.states.at(-1)).toMatchObject({ status: 'connected', clientId: id, resumed: true });
    expect(await stateOf(world, ada.client)).toBe(ClientState.ACTIVE);
    expect(deleted).toEqual([]);
    expect((await ben.client.call('deviceGetList')).elements).toMatchObject([{ clientId: id }]);
  });

  it('gets what was published while it was away [TD-33]', async () => {
    const { world, ada, ben } = await setupTwo();
    const byTopic = collect(ben.client.subscribe('/a'));
    const byGlob = collect(ben.client.subscribe({ glob: '/*' }));
    await world.pass(0);
    await world.drop();
    ada.client.publish('/a', 'int32', 1);
    ada.client.publish('/a', 'int32', 2);
    await world.pass(2_000);
    expect(ben.client.state.status).toBe('connected');
    expect(values(byTopic)).toContain(2);
    expect(values(byGlob)).toContain(2);
    byTopic.length = 0;
    ada.client.publish('/a', 'int32', 3);
    await world.pass(50);
    expect(values(byTopic)).toEqual([3]);
  });

  it('is away for 30 s and finds its subscriptions as they were [CL-13]', async () => {
    const { world, ada, ben } = await setupTwo();
    const records = collect(ben.client.subscribe('/a'));
    await world.pass(0);
    const open = world.openConnection.bind(world);
    world.openConnection = (query, peer) =>
      query.clientId === ben.client.id ? undefined : open(query, peer);
    await world.drop();
    await world.pass(30_000);
    expect(ben.client.state.status).toBe('reconnecting');
    expect(await stateOf(world, ben.client)).toBe(ClientState.UNAVAILABLE);
    world.openConnection = open;
    await world.pass(6_000);
    expect(ben.states.at(-1)).toMatchObject({ status: 'connected', resumed: true });
    ada.client.publish('/a', 'int32', 1);
    await world.pass(50);
    expect(values(records)).toEqual([1]);
  });

  it('is the same client after the master has removed it [CL-14] [CL-3]', async () => {
    const world = new ClientWorld({ unavailableRetentionMs: 5_000 });
    const { client, states } = await world.connect('ada');
    const { id } = client;
    await client.registerDevice(mouse);
    world.isDown = true;
    await world.drop();
    await world.pass(20_000);
    expect(await stateOf(world, client)).toBeUndefined();
    world.isDown = false;
    await world.pass(6_000);
    expect(states.at(-1)).toMatchObject({ status: 'connected', clientId: id, resumed: true });
    expect((await client.call('deviceGetList')).elements).toMatchObject([{ clientId: id }]);
  });

  it('keeps its socket when an older attempt arrives after it [EX-51]', async () => {
    const { world, ada } = await setupTwo();
    const late = new RecordingConnection();
    world.test.master.openConnection(
      { clientId: ada.client.id, token: world.test.tokens.issue(ada.client.id), sentMs: 1 },
      late,
      TRUSTED_CALLER,
    );
    await world.pass(60_000);
    expect(late.sent).toEqual([{ kind: 'close', reason: 'superseded' }]);
    expect(ada.client.state).toMatchObject({ status: 'connected' });
  });

  it('stops when another socket takes its identity [TD-7] [EX-5]', async () => {
    const { world, ada } = await setupTwo();
    world.test.master.openConnection(
      { clientId: ada.client.id, token: world.test.tokens.issue(ada.client.id) },
      new RecordingConnection(),
      TRUSTED_CALLER,
    );
    await world.pass(60_000);
    expect(ada.client.state).toMatchObject({ status: 'closed', error: { reason: 'superseded' } });
  });
});

describe('clients of ours whose master is restarted', () => {
  it('come back as the same clients, with devices and subscriptions [CL-3] [EX-3]', async () => {
    const { world, ada, ben } = await setupTwo();
    const ids = [ada.client.id, ben.client.id];
    const device = await ada.client.registerDevice(mouse);
    const deviceId = device.id;
    const byTopic = collect(ben.client.subscribe(device.component('position').topic));
    const byGlob = collect(ben.client.subscribe({ glob: '/*/mouse/*' }));
    const byProfile = collect(ben.client.subscribe({ component: { tags: ['pointer'] } }));
    await world.pass(50);
    await world.restart();
    await world.pass(5_000);
    expect([ada.client.id, ben.client.id]).toEqual(ids);
    for (const { states } of [ada, ben]) {
      expect(states.at(-1)).toMatchObject({ status: 'connected', resumed: true });
    }
    expect((await ben.client.call('deviceGetList')).elements).toMatchObject([{ id: deviceId }]);
    device.component('position').publish({ x: 1, y: 2 });
    await world.pass(50);
    for (const records of [byTopic, byGlob, byProfile]) {
      expect(values(records)).toEqual([{ x: 1, y: 2 }]);
    }
  });

  it('publish what they had to say meanwhile, the newest of each topic', async () => {
    const { world, ada, ben } = await setupTwo();
    const records = collect(ben.client.subscribe('/a'));
    await world.pass(50);
    world.isDown = true;
    await world.restart();
    for (let i = 1; i <= 5; i++) ada.client.publish('/a', 'int32', i);
    await world.pass(5_000);
    world.isDown = false;
    await world.pass(6_000);
    expect(values(records)).toEqual([5]);
    expect(ada.client.counters.recordsDropped).toBe(4);
  });
});

describe('a client of ours that leaves', () => {
  it('takes its devices, topics and itself along [CL-16] [TD-40]', async () => {
    const { world, ada, ben } = await setupTwo();
    const device = await ada.client.registerDevice(mouse);
    device.component('position').publish({ x: 1, y: 2 });
    await world.pass(50);
    expect((await ben.client.call('topicList')).elements).toContain(
      device.component('position').topic,
    );
    const closed = ada.client.close();
    await world.pass(0);
    await closed;
    expect((await ben.client.call('topicList')).elements).not.toContain(
      device.component('position').topic,
    );
    expect((await ben.client.call('clientGetList')).elements.map(({ name }) => name)).toEqual([
      'ben',
    ]);
  });

  it('leaves nothing of an earlier run behind when it is started again [EX-7]', async () => {
    const { world, ada } = await setupTwo();
    const identity = createMemoryIdentity();
    const first = await world.connect('cleo', {
      identity,
      reconnect: { giveUpAfterAttempts: 0 }, // a crash: it does not come back
    });
    const { id } = first.client;
    await first.client.registerDevice(mouse);
    first.client.subscribe({ glob: '/**' });
    await world.pass(50);
    await world.drop();
    await world.pass(2_000);

    const { client, states } = await world.connect('cleo', { identity });
    expect(states.at(-1)).toMatchObject({ status: 'connected', clientId: id, resumed: true });
    expect((await ada.client.call('deviceGetList')).elements).toEqual([]);
    ada.client.publish('/a', 'int32', 1);
    await world.pass(50);
    expect(client.counters.recordsIn).toBe(0);
  });

  it('does not fight forever with a second program of the same identity', async () => {
    const world = new ClientWorld();
    const identity = createMemoryIdentity();
    const first = await world.connect('cleo', { identity });
    const second = await world.connect('cleo', { identity });
    await world.pass(60_000);
    expect([first.client.state.status, second.client.state.status].sort()).toEqual([
      'closed',
      'connected',
    ]);
    expect([...first.states, ...second.states]).toContainEqual(
      expect.objectContaining({
        error: expect.objectContaining({ reason: 'superseded' }) as unknown,
      }),
    );
  });
});

describe('the time of the master', () => {
  it('is known to its clients, and the master knows how well [TS-1] [TS-10]', async () => {
    const { world, ada } = await setupTwo();
    await world.pass(5_000);
    expect(ada.client.masterTime.nowMs()).toBe(world.clock.nowMs());
    const { clientReport } = await world.test.call({
      topic: '/services/ubii/client_report',
      clientReportRequest: { clientIds: [ada.client.id] },
    });
    expect(clientReport?.clients[0]?.clock).toMatchObject({ offsetMs: 0, driftPpm: 0 });
    expect(clientReport?.clients[0]?.clock?.errorMs).toBeGreaterThan(0);
  });
});
