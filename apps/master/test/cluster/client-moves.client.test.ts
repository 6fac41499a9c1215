import { createClient, type ClientOptions } from '@ubii/client-web/node';
import { createMemoryServices, createMemoryTopicData } from '@ubii/client-web/testing';
import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { MemoryMasterOf } from '../memory-master-of.ts';
import { ClusterWorld } from './cluster-world.ts';

const URLS = ['http://10.0.0.1:8080', 'http://10.0.0.2:8080', 'http://10.0.0.3:8080'] as const;

/** Masters of a cluster, three at the start, with clients of our library over channels in memory. */
async function setup(count = 3) {
  const world = new ClusterWorld();
  const doors = new Map<string, MemoryMasterOf>();
  const open = async (url: string): Promise<void> => {
    const test = await world.add({ endpoints: { addresses: [{ url }] } });
    doors.set(url, new MemoryMasterOf(() => test, world.clock));
  };
  for (const url of URLS.slice(0, count)) await open(url);
  const waysTo = (url: string) => ({
    services: createMemoryServices(doors.get(url)!),
    topicData: createMemoryTopicData(doors.get(url)!),
  });
  const pass = async (ms: number): Promise<void> => {
    for (let passedMs = 0; passedMs <= ms; passedMs += 50) {
      world.clock.advanceSync(passedMs === 0 ? 0 : 50);
      await settle();
    }
  };
  const connect = async (url: string, options: Partial<ClientOptions> = {}) => {
    const client = createClient({
      url,
      name: 'phone',
      publishIntervalMs: 0,
      clock: world.clock,
      random: () => 0,
      transports: { ...waysTo(url), waysTo },
      ...options,
    });
    const connected = client.connect();
    await pass(200);
    await connected;
    return client;
  };
  /** The computer of a master fails: clients and masters receive nothing from it any more. */
  const kill = async (at: number): Promise<void> => {
    world.setReachable(world.masters[at]!, false);
    await doors.get(URLS[at]!)!.die();
  };
  return { world, pass, connect, kill, open };
}

describe('a client of our library at a cluster', () => {
  it('[CU-83] goes on at another master when its own one is killed, and others notice nothing else', async () => {
    const { pass, connect, kill } = await setup();
    const phone = await connect(URLS[0]);
    const screen = await connect(URLS[1], { name: 'screen' });
    const device = await phone.registerDevice({
      name: 'pad',
      components: [{ name: 'tap', format: 'int32' }],
    });
    const tap = device.component('tap');
    const seen: unknown[] = [];
    screen.subscribe(tap.topic).onRecord(({ value }) => seen.push(value));
    const lamps: unknown[] = [];
    phone.subscribe('/lamp').onRecord(({ value }) => lamps.push(value));
    await pass(200);
    tap.publish(1);
    screen.publish('/lamp', 'bool', true);
    await pass(200);
    expect([seen, lamps]).toEqual([[1], [true]]);
    expect([...phone.otherMasters].sort()).toEqual([URLS[1], URLS[2]]);

    const moves: unknown[] = [];
    phone.onMaster(({ url, previousUrl }) => moves.push([previousUrl, url]));
    const { id } = phone;
    await kill(0);
    await pass(200);
    tap.publish(2); // waits
    await pass(6_000);
    expect(moves).toEqual([[URLS[0], phone.masterUrl]]);
    expect(phone.masterUrl).not.toBe(URLS[0]);
    expect([phone.id, phone.state.status]).toEqual([id, 'connected']);
    tap.publish(3);
    screen.publish('/lamp', 'bool', false);
    await pass(200);
    expect(seen).toEqual([1, 2, 3]);
    expect(lamps.at(-1)).toBe(false);
    const devices = await Promise.all([screen.call('deviceGetList', {}), pass(200)]);
    expect(devices[0].elements).toMatchObject([{ id: device.id, clientId: id, name: 'pad' }]);
    const clients = await Promise.all([screen.call('clientGetList', {}), pass(200)]);
    expect(clients[0].elements.filter(({ name }) => name === 'phone')).toHaveLength(1);
    expect(phone.otherMasters).not.toContain(phone.masterUrl);
  });

  it('[CU-80] hears of a master that starts later, and goes there', async () => {
    const { world, pass, connect, kill, open } = await setup(1);
    const phone = await connect(URLS[0]);
    expect(phone.otherMasters).toEqual([]);
    await open(URLS[1]);
    await pass(3_000);
    expect(phone.otherMasters).toEqual([URLS[1]]);
    const { id } = phone;
    await kill(0);
    await pass(8_000);
    expect([phone.id, phone.masterUrl, phone.state.status]).toEqual([id, URLS[1], 'connected']);
    expect(world.masters).toHaveLength(2);
  });

  it('[CU-83] is the one that counts when it comes back from a master that was only cut off', async () => {
    const { world, pass, connect, kill } = await setup();
    const phone = await connect(URLS[0]);
    await pass(200);
    await kill(0);
    await pass(10_000);
    world.setReachable(world.masters[0]!, true);
    await pass(10_000);
    for (const master of world.masters) {
      const { clientList } = await master.call({
        topic: '/services/client/get_list',
        clientList: {},
      });
      expect(clientList?.elements.map(({ id }) => id)).toEqual([phone.id]);
    }
    expect(phone.state.status).toBe('connected');
  });
});
