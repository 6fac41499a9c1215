import { describe, expect, it } from 'vitest';
import { SessionState, type Init, type Session } from '@ubii/proto';
import type { TestClient, TestMaster } from '../../src/testing/index.ts';
import { doubling, TOPICS } from '../sessions/session-world.ts';
import type { ClusterWorld } from './cluster-world.ts';
import { clusterOf } from './cluster-world.ts';

/** Asks a master, and lets messages between masters arrive meanwhile. */
async function ask(
  world: ClusterWorld,
  master: TestMaster,
  topic: string,
  session: Init<Session>,
): Promise<Session> {
  const replied = master.master.handleServiceRequest(await requestOf(topic, session), {
    standing: 'trusted',
    isHere: true,
    place: 'here',
    bearer: undefined,
  });
  await world.pass(100);
  const { reply } = await replied;
  if (reply.error) throw new Error(`${reply.error.code}: ${reply.error.message}`);
  return reply.session as Session;
}

async function requestOf(topic: string, session: Init<Session>) {
  const { decode, encode } = await import('@ubii/proto');
  const bytes = encode('ubii.services.ServiceRequest', { topic, session });
  return decode('ubii.services.ServiceRequest', bytes);
}

async function stateAt(master: TestMaster, id: string): Promise<SessionState | undefined> {
  const { sessionList } = await master.call({ topic: TOPICS.list });
  return sessionList?.elements.find((session) => session.id === id)?.extension?.state;
}

/** Publishes a number, and says what came of it. */
async function doubled(world: ClusterWorld, client: TestClient, value: number): Promise<unknown> {
  client.takeValues();
  client.publish('/in', 'double', value);
  await world.pass(100);
  return client.takeValues().find(([topic]) => topic === '/out')?.[1];
}

describe('sessions of a cluster', () => {
  it('[CU-30] are seen, started and stopped at every master, and run at one', async () => {
    const [world, a, b] = await clusterOf(2);
    const client = await b!.extension('client');
    await client.subscribe({ subscribeTopics: ['/out'] });
    const { id } = await ask(world, a!, TOPICS.add, doubling('/in', '/out'));
    expect(await stateAt(b!, id)).toBe(SessionState.SESSION_CREATED);
    await ask(world, b!, TOPICS.start, { id });
    await world.pass(500);
    expect(await stateAt(a!, id)).toBe(SessionState.SESSION_RUNNING);
    expect(await stateAt(b!, id)).toBe(SessionState.SESSION_RUNNING);
    expect(await doubled(world, client, 4)).toBe(8);
    await ask(world, b!, TOPICS.stop, { id });
    await world.pass(500);
    expect(await stateAt(a!, id)).toBe(SessionState.SESSION_STOPPED);
    await ask(world, b!, TOPICS.remove, { id });
    expect(await stateAt(b!, id)).toBeUndefined();
    expect(await stateAt(a!, id)).toBeUndefined();
  });

  it('[CU-30] are announced to the clients of every master', async () => {
    const [world, a, b] = await clusterOf(2);
    const client = await b!.extension('client');
    await client.subscribe({ subscribeTopicRegexp: ['^/info/session/'] });
    await ask(world, a!, TOPICS.start, doubling('/in', '/out'));
    await world.pass(500);
    const topics = client.takeRecords().map(({ topic }) => topic);
    for (const word of ['new', 'start', 'change', 'running']) {
      expect(topics).toContain(`/info/session/${word}`);
    }
    const statistics = await b!.extension('page');
    await statistics.subscribe({ subscribeTopicRegexp: ['^/ubii/session/'] });
    await world.pass(3_000);
    expect(statistics.takeRecords().length).toBeGreaterThan(0);
  });

  it('[CU-30] that became known with a new stream are announced, once', async () => {
    const [world, a, b] = await clusterOf(2);
    const client = await b!.extension('client');
    await client.subscribe({ subscribeTopicRegexp: ['^/info/session/'] });
    const words = () => client.takeRecords().map(({ topic }) => topic.split('/').at(-1));
    world.hub.setReachable(a!.master.id, false);
    const { id } = await ask(world, a!, TOPICS.add, doubling('/in', '/out'));
    expect(words()).toEqual([]);
    world.hub.setReachable(a!.master.id, true);
    await world.pass(4_000);
    expect(await stateAt(b!, id)).toBe(SessionState.SESSION_CREATED);
    expect(words()).toEqual(['new']);
    world.hub.setReachable(a!.master.id, false);
    await ask(world, a!, TOPICS.start, { id });
    world.hub.setReachable(a!.master.id, true);
    await world.pass(4_000);
    expect(await stateAt(b!, id)).toBe(SessionState.SESSION_RUNNING);
    expect(words()).toEqual(['change']);
  });

  it('[CU-31] are opened once, when two masters open the same stored one', async () => {
    const [world, a, b] = await clusterOf(2);
    await ask(world, a!, TOPICS.save, doubling('/in', '/out'));
    const { sessionList } = await a!.call({ topic: TOPICS.stored });
    const { id } = sessionList!.elements[0]!;
    const open = await stateAt(a!, id);
    expect(open).toBe(SessionState.SESSION_CREATED);
    await ask(world, b!, TOPICS.start, { name: 'doubling' });
    await world.pass(500);
    const { sessionList: all } = await b!.call({ topic: TOPICS.list });
    expect(all?.elements).toHaveLength(1);
    expect(await stateAt(a!, id)).toBe(SessionState.SESSION_RUNNING);
  });

  it('[CU-32] go on at another master within five seconds when theirs is lost', async () => {
    const [world, a, b, c] = await clusterOf(3);
    const client = await c!.extension('client');
    await client.subscribe({ subscribeTopics: ['/out'] });
    const { id } = await ask(world, a!, TOPICS.start, doubling('/in', '/out'));
    const { id: other } = await ask(world, a!, TOPICS.add, {
      ...doubling('/x', '/y'),
      name: 'idle',
    });
    await world.pass(3_000);
    world.setReachable(a!, false);
    await world.pass(5_000);
    expect(await stateAt(b!, id)).toBe(SessionState.SESSION_RUNNING);
    expect(await stateAt(c!, id)).toBe(SessionState.SESSION_RUNNING);
    expect(await stateAt(c!, other)).toBe(SessionState.SESSION_CREATED);
    expect(await doubled(world, client, 5)).toBe(10);
  });

  it('[CU-32] go on at once when theirs ends, and when a master comes back after all ended', async () => {
    const [world, a, b] = await clusterOf(2);
    const { id } = await ask(world, a!, TOPICS.start, doubling('/in', '/out'));
    await world.pass(3_000);
    await a!.master.close();
    await world.pass(1_000);
    expect(await stateAt(b!, id)).toBe(SessionState.SESSION_RUNNING);
    await b!.master.close();
    const c = await world.add();
    await c.pass(5_000);
    expect(await stateAt(c, id)).toBe(SessionState.SESSION_RUNNING);
  });

  it('[CU-34] run at one master after both sides of a cluster were apart', async () => {
    const [world, a, b] = await clusterOf(2);
    const atA = await a!.extension('at a');
    await atA.subscribe({ subscribeTopics: ['/out'] });
    const { id } = await ask(world, a!, TOPICS.start, doubling('/in', '/out'));
    await world.pass(3_000);
    world.setReachable(a!, false);
    await world.pass(6_000);
    // Each side goes on.
    expect(await stateAt(a!, id)).toBe(SessionState.SESSION_RUNNING);
    expect(await stateAt(b!, id)).toBe(SessionState.SESSION_RUNNING);
    expect(await doubled(world, atA, 1)).toBe(2);
    world.setReachable(a!, true);
    await world.pass(6_000);
    const { sessionList } = await a!.call({ topic: TOPICS.list });
    expect(sessionList?.elements).toHaveLength(1);
    expect(await doubled(world, atA, 3)).toBe(6);
    // The one that continues is stored: it outlives this master as well. [CU-33]
    await b!.master.close();
    await world.pass(5_000);
    expect(await stateAt(a!, id)).toBe(SessionState.SESSION_RUNNING);
    expect(await doubled(world, atA, 4)).toBe(8);
    const { masterStatus } = await a!.call({
      topic: '/services/ubii/master_status',
      masterStatusRequest: {},
    });
    expect(masterStatus?.events.map(({ text }) => text).join('\n')).toContain('took it over');
  });

  it('[CU-34] that were opened and removed while the store was away are so afterwards', async () => {
    const [world, a, b] = await clusterOf(2);
    const { id: removed } = await ask(world, a!, TOPICS.start, doubling('/in', '/out'));
    await world.pass(3_000);
    world.setReachable(a!, false);
    const { id: made } = await ask(world, a!, TOPICS.start, {
      ...doubling('/x', '/y'),
      name: 'made',
    });
    await ask(world, a!, TOPICS.remove, { id: removed });
    await world.pass(500);
    world.setReachable(a!, true);
    await world.pass(8_000);
    expect(await stateAt(b!, removed)).toBeUndefined();
    await a!.master.close();
    await world.pass(5_000);
    expect(await stateAt(b!, made)).toBe(SessionState.SESSION_RUNNING);
    expect(await stateAt(b!, removed)).toBeUndefined();
  });

  it('[CU-31] have a master that runs them when the answer to a claim is lost', async () => {
    const [world, a, b] = await clusterOf(2);
    const { id } = await ask(world, a!, TOPICS.start, doubling('/in', '/out'));
    await world.pass(3_000);
    // The store has the claim, and the master that claimed does not know.
    const other = world.owners.open();
    world.setReachable(a!, false);
    await other.claim(id, b!.master.id, a!.master.id);
    await world.pass(8_000);
    expect(await stateAt(b!, id)).toBe(SessionState.SESSION_RUNNING);
  });

  it('[CU-30] of a lost master without an owner are removed from lists', async () => {
    const [world, a, b] = await clusterOf(2);
    const { id } = await ask(world, a!, TOPICS.add, doubling('/in', '/out'));
    expect(await stateAt(b!, id)).toBe(SessionState.SESSION_CREATED);
    world.hub.setReachable(a!.master.id, false);
    await ask(world, a!, TOPICS.remove, { id });
    await world.pass(8_000);
    expect(await stateAt(b!, id)).toBeUndefined();
  });
});
