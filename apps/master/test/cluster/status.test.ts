import { ClusterMasterState, type ClusterMaster, type ClusterStatus } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestMaster as Master } from '../../src/testing/index.ts';
import { doubling, TOPICS } from '../sessions/session-world.ts';
import { clusterOf, ClusterWorld, publisherAndSubscriber } from './cluster-world.ts';

const { SELF, PRESENT, LOST, ENDED } = ClusterMasterState;

async function statusOf(master: Master) {
  const topic = '/services/ubii/master_status';
  const { masterStatus } = await master.call({ topic, masterStatusRequest: {} });
  return masterStatus!;
}

async function clusterAt(master: Master): Promise<ClusterStatus> {
  return (await statusOf(master)).cluster!;
}

function find({ masters }: ClusterStatus, name: string): ClusterMaster {
  return masters.find((master) => master.name === name)!;
}

/** Id of the master of each client, by its name, as the list at a master has it. */
async function mastersOfClients(master: Master): Promise<Record<string, string | undefined>> {
  const { clientList } = await master.call({
    topic: '/services/client/get_list',
    clientList: {},
  });
  return Object.fromEntries(
    clientList!.elements.map(({ name, extension }) => [name, extension?.masterId]),
  );
}

async function sessionAt(master: Master, id: string) {
  const { sessionList } = await master.call({ topic: TOPICS.list });
  return sessionList?.elements.find((session) => session.id === id)?.extension;
}

describe('the status of a cluster', () => {
  it('[CU-72] lists the own master first, then the others with what they say of themselves', async () => {
    const [world, a, b] = await clusterOf(2);
    await a!.extension('at a');
    await b!.extension('at b');
    await world.pass();
    const cluster = await clusterAt(a!);
    expect(cluster).toMatchObject({ name: 'test', reachable: true, gaps: 0 });
    expect(cluster.masters).toMatchObject([
      { id: a!.master.id, name: 'master 1', state: SELF, version: '1.2.3', clients: 1 },
      { id: b!.master.id, name: 'master 2', state: PRESENT, version: '1.2.3', clients: 1 },
    ]);
    const { startedMs } = await statusOf(b!);
    expect(find(cluster, 'master 2').startedMs).toBe(startedMs);
  });

  it('[CU-72] is absent at a master that is alone', async () => {
    const status = await statusOf(new TestMaster());
    expect(status.cluster).toBeUndefined();
  });

  it('[CU-72] tells masters that ended from those that are not heard, and forgets both', async () => {
    const [world, a, b, c] = await clusterOf(3);
    await b!.master.close();
    world.hub.setReachable(c!.master.id, false);
    await world.pass(4_000);
    const cluster = await clusterAt(a!);
    expect(find(cluster, 'master 2')).toMatchObject({ state: ENDED, clients: 0 });
    expect(find(cluster, 'master 3').state).toBe(LOST);
    world.hub.setReachable(c!.master.id, true);
    await world.pass(2_000);
    expect(find(await clusterAt(a!), 'master 3').state).toBe(PRESENT);
    await world.pass(11 * 60_000);
    expect((await clusterAt(a!)).masters).toHaveLength(2);
  });

  it('[CU-73] has what crosses in each direction', async () => {
    const { world, a, b, publisher } = await publisherAndSubscriber();
    await world.pass(4_000);
    for (let i = 0; i < 4; i++) {
      publisher.publish('/a', 'double', i);
      await world.pass();
    }
    await world.pass(1_900);
    const other = find(await clusterAt(a), 'master 2');
    expect(other).toMatchObject({ recordsTo: 4, recordsFrom: 0, complete: true });
    const own = find(await clusterAt(b), 'master 1');
    expect(own).toMatchObject({ recordsTo: 0, recordsFrom: 4, dropped: 0, gaps: 0 });
    expect(other.recordsToPerSecond).toBeGreaterThan(0);
    expect(other.recordsToPerSecond).toBe(own.recordsFromPerSecond);
    expect(other.bytesToPerSecond).toBeGreaterThan(0);
    await world.pass(4_000);
    expect(find(await clusterAt(a), 'master 2').recordsToPerSecond).toBe(0);
  });

  it('[CU-73] counts what was missing, also of a master that is gone', async () => {
    const [world, a, b] = await clusterOf(2);
    const publisher = await b!.extension('publisher');
    const subscriber = await a!.extension('subscriber');
    await subscriber.subscribe({ subscribeTopics: ['/a'] });
    await world.pass();
    world.hub.lose(1);
    publisher.publish('/a', 'double', 1);
    publisher.publish('/a', 'double', 2);
    await world.pass(2_000);
    const before = await clusterAt(a!);
    expect(find(before, 'master 2').gaps).toBe(1);
    await b!.master.close();
    await world.pass();
    expect((await clusterAt(a!)).gaps).toBe(before.gaps);
  });

  it('[CU-73] does not count a request that was lost before a master told anything', async () => {
    const world = new ClusterWorld();
    const a = await world.add();
    // After the hello of the new master: what the other one says and requests then.
    world.hub.lose(2, 1);
    const b = await world.add();
    await world.pass(8_000);
    for (const master of [a, b]) {
      const { gaps, masters } = await clusterAt(master);
      expect([gaps, masters[1]?.complete]).toEqual([0, true]);
    }
  });

  it('[CU-75] says since when the bus cannot be reached, and that it is a problem', async () => {
    const [world, a] = await clusterOf(2);
    await world.pass(3_000);
    expect((await statusOf(a!)).problems).toEqual([]);
    world.hub.setReachable(a!.master.id, false);
    await world.pass(1);
    const sinceMs = world.clock.nowMs() - 1;
    await world.pass(5_000);
    const { cluster, problems } = await statusOf(a!);
    expect(cluster).toMatchObject({ reachable: false, reachableSinceMs: sinceMs });
    expect(problems).toMatchObject([{ code: 'cluster_unreachable', sinceMs }]);
    world.hub.setReachable(a!.master.id, true);
    await world.pass(2_000);
    expect((await statusOf(a!)).problems).toEqual([]);
    expect((await clusterAt(a!)).reachable).toBe(true);
  });
});

describe('the master', () => {
  it('[CU-70] of a client is in lists and announcements of every master', async () => {
    const [world, a, b] = await clusterOf(2);
    const page = await a!.extension('page');
    await page.subscribe({ subscribeTopicRegexp: ['^/ubii/client/'] });
    page.takeRecords();
    const phone = await b!.extension('phone');
    await world.pass();
    const expected = { page: a!.master.id, phone: b!.master.id };
    expect(await mastersOfClients(a!)).toEqual(expected);
    expect(await mastersOfClients(b!)).toEqual(expected);
    const told = page.takeRecords().findLast(({ topic }) => topic.endsWith(phone.id));
    expect(told).toMatchObject({ value: { extension: { masterId: b!.master.id } } });
  });

  it('[CU-70] of a client is not told by a master that is alone', async () => {
    const alone = new TestMaster();
    await alone.extension('page');
    expect(await mastersOfClients(alone)).toEqual({ page: '' });
  });

  it('[CU-71] of a session is told everywhere, and from where the session came', async () => {
    const [world, a, b, c] = await clusterOf(3);
    const { session } = await a!.call({ topic: TOPICS.start, session: doubling('/in', '/out') });
    const { id } = session as { id: string };
    await world.pass(3_000);
    expect(await sessionAt(c!, id)).toMatchObject({ masterId: a!.master.id, movedMs: 0 });
    world.setReachable(a!, false);
    await world.pass(6_000);
    const atB = await sessionAt(b!, id);
    expect(atB).toMatchObject({ movedFrom: 'master 1' });
    expect(atB?.movedMs).toBeGreaterThan(0);
    expect(await sessionAt(c!, id)).toEqual(atB);
    expect([b!.master.id, c!.master.id]).toContain(atB?.masterId);
    const name = atB?.masterId === b!.master.id ? 'master 2' : 'master 3';
    expect(find(await clusterAt(b!), name).sessions).toBe(1);
  });

  it('[CU-71] of a session stays that of the lost master until another takes it over', async () => {
    const [world, a, b] = await clusterOf(2);
    const { session } = await a!.call({ topic: TOPICS.start, session: doubling('/in', '/out') });
    const { id } = session as { id: string };
    await world.pass(3_000);
    // Only the messages are lost: b cannot claim it while its own store is away.
    world.setReachable(b!, false);
    await world.pass(5_000);
    expect(find(await clusterAt(b!), 'master 1').state).toBe(LOST);
    expect(await sessionAt(b!, id)).toMatchObject({ masterId: a!.master.id });
  });

  it('[CU-76] that a module names as its node is the one that runs the session', async () => {
    const [world, a, b] = await clusterOf(2);
    const wish = doubling('/in', '/out');
    const processingModules = wish.processingModules!.map((module) => ({
      ...module,
      nodeId: b!.master.id,
    }));
    const { session } = await a!.call({
      topic: TOPICS.start,
      session: { ...wish, processingModules },
    });
    await world.pass(1_000);
    const { sessionList } = await b!.call({ topic: TOPICS.list });
    const told = sessionList?.elements.find(({ id }) => id === session?.id);
    expect(told?.processingModules.map(({ nodeId }) => nodeId)).toEqual([a!.master.id]);
    expect(told?.extension?.problems.filter(({ isError }) => isError)).toEqual([]);
  });
});
