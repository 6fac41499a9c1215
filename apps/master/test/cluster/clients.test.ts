import { describe, expect, it } from 'vitest';
import type { TestMaster } from '../../src/testing/index.ts';
import { ClusterWorld, clusterOf } from './cluster-world.ts';

async function namesAt(master: TestMaster): Promise<string[]> {
  const { clientList } = await master.call({ topic: '/services/client/get_list', clientList: {} });
  return (clientList?.elements ?? []).map(({ name }) => name).sort();
}

/** After what the clock of these stories shows. */
const LATER_MS = 1e15;

describe('clients of a cluster', () => {
  it('[CU-20] are in the lists of every master, with their devices and their state', async () => {
    const [world, a, b, c] = await clusterOf(3);
    await a!.extension('phone', { devices: [{ name: 'sensor', components: [{ topic: '/s' }] }] });
    await b!.legacy('robot');
    await world.pass();
    for (const master of [a!, b!, c!]) {
      expect(await namesAt(master)).toEqual(['phone', 'robot']);
      const { deviceList } = await master.call({
        topic: '/services/device/get_list',
        deviceList: {},
      });
      expect(deviceList?.elements.map(({ name }) => name)).toEqual(['sensor']);
    }
  });

  it('[CU-20] are told to a master that starts later', async () => {
    const [world, a] = await clusterOf(1);
    for (let i = 0; i < 120; i++) await a!.extension(`client ${i}`);
    const late = await world.add();
    expect(await namesAt(late)).toHaveLength(120);
  });

  it('[CU-20] are announced and removed everywhere', async () => {
    const [world, a, b] = await clusterOf(2);
    const page = await b!.extension('page');
    await page.subscribe({
      subscribeTopicRegexp: ['^/ubii/client/.*'],
      subscribeTopics: ['/info/device/new'],
    });
    page.takeValues();
    const phone = await a!.extension('phone', { devices: [{ name: 'sensor' }] });
    await world.pass();
    const topics = page.takeRecords().map(({ topic }) => topic);
    expect(topics).toContain(`/ubii/client/${phone.id}`);
    expect(topics).toContain('/info/device/new');
    phone.drop('left');
    await world.pass();
    expect(await namesAt(b!)).toEqual(['page']);
  });

  it('[CU-21] whose master is lost come back as themselves at another one', async () => {
    const [world, a, b, c] = await clusterOf(3);
    const phone = await a!.extension('phone', {
      devices: [{ name: 'sensor', components: [{ topic: '/s' }] }],
    });
    await world.pass();
    world.hub.setReachable(a!.master.id, false);
    await world.pass(5_000);
    const back = await b!.register({
      name: 'phone',
      id: phone.id,
      extension: { resumeToken: phone.token! },
    });
    expect(back.id).toBe(phone.id);
    expect(back.registered.extension?.resumed).toBe(true);
    expect(back.open()).toBe(true);
    await world.pass(20_000);
    for (const master of [b!, c!]) expect(await namesAt(master)).toEqual(['phone']);
    const subscriber = await c!.extension('screen');
    await subscriber.subscribe({ subscribeTopics: ['/s'] });
    await world.pass();
    back.publish('/s', 'double', 1);
    await world.pass();
    expect(subscriber.takeValues()).toEqual([['/s', 1]]);
  });

  it('[CU-26] are told where else they can go, and when that changes', async () => {
    const world = new ClusterWorld();
    const at = (port: number) => ({
      endpoints: { addresses: [{ url: `http://127.0.0.1:${port}` }] },
    });
    const a = await world.add(at(1));
    const phone = await a.extension('phone');
    expect(phone.registered.extension?.masters).toEqual([]);
    await phone.subscribe({ subscribeTopics: ['/ubii/masters'] });
    const b = await world.add(at(2));
    expect(phone.takeValues()).toEqual([['/ubii/masters', { elements: ['http://127.0.0.1:2'] }]]);
    const other = await a.extension('other');
    expect(other.registered.extension?.masters).toEqual(['http://127.0.0.1:2']);
    // A master that receives nothing may be cut off itself.
    world.setReachable(b, false);
    await world.pass(4_000);
    const { extension } = (await a.extension('third')).registered;
    expect(extension?.masters).toEqual(['http://127.0.0.1:2']);
    world.setReachable(b, true);
    await world.pass(1_000);
    phone.takeValues();
    await b.master.close();
    await world.pass();
    expect(phone.takeValues()).toEqual([['/ubii/masters', { elements: [] }]]);
    expect((await a.extension('fourth')).registered.extension?.masters).toEqual([]);
  });

  it('[CU-26] are not told for long of masters that died while others are there', async () => {
    const world = new ClusterWorld();
    const [a, b, c] = [
      await world.add({ endpoints: { addresses: [{ url: 'http://127.0.0.1:1' }] } }),
      await world.add({ endpoints: { addresses: [{ url: 'http://127.0.0.1:2' }] } }),
      await world.add({ endpoints: { addresses: [{ url: 'http://127.0.0.1:3' }] } }),
    ];
    const told = async () => (await a.extension('phone')).registered.extension?.masters;
    world.setReachable(b, false);
    await world.pass(10_000);
    expect(await told()).toEqual(['http://127.0.0.1:3']);
    world.setReachable(c, false);
    await world.pass(10_000);
    expect(await told()).toEqual(['http://127.0.0.1:3']);
  });

  it('[CU-21] that do not come back are removed like absent ones', async () => {
    const world = new ClusterWorld();
    const a = await world.add();
    const b = await world.add({ limits: { unavailableRetentionMs: 60_000 } });
    await a.extension('phone');
    await world.pass();
    world.hub.setReachable(a.master.id, false);
    await world.pass(4_000);
    expect(await namesAt(b)).toEqual(['phone']);
    await world.pass(80_000);
    expect(await namesAt(b)).toEqual([]);
  });

  it('[CU-22] are at the master they came to last, when both were apart', async () => {
    const [world, a, b] = await clusterOf(2);
    const phone = await a!.extension('phone');
    await world.pass();
    world.hub.cut(a!.master.id, b!.master.id);
    await world.pass(5_000);
    const back = await b!.register({
      name: 'phone',
      id: phone.id,
      extension: { resumeToken: phone.token! },
    });
    back.open();
    world.hub.heal();
    await world.pass(5_000);
    expect(phone.closed?.reason).toBe('superseded');
    expect(back.closed).toBeUndefined();
    for (const master of [a!, b!]) expect(await namesAt(master)).toEqual(['phone']);
  });

  it('[CU-22] [EX-51] stay where they went when an older registration arrives after it', async () => {
    const [world, a, b] = await clusterOf(2);
    const phone = await a!.extension('phone');
    await world.pass();
    const as = (sentMs: number) => ({
      name: 'phone',
      id: phone.id,
      extension: { resumeToken: phone.token!, sentMs },
    });
    await a!.register(as(LATER_MS));
    world.hub.cut(a!.master.id, b!.master.id);
    await world.pass(5_000);
    const moved = await b!.register(as(LATER_MS + 2_000));
    moved.open();
    await world.pass(1_000);
    // The network delivers what the client sent to its master before it gave up.
    await a!.register(as(LATER_MS + 1_000));
    world.hub.heal();
    await world.pass(5_000);
    await expect(a!.register(as(LATER_MS + 1_500))).rejects.toThrow(/older than the one/);
    await world.pass(1_000);
    expect(moved.closed).toBeUndefined();
    for (const master of [a!, b!]) expect(await namesAt(master)).toEqual(['phone']);
  });

  it('[CU-21] [EX-51] of a lost master come back also with a clock that was set back', async () => {
    const [world, a, b] = await clusterOf(2);
    const phone = await a!.extension('phone');
    await world.pass();
    world.hub.setReachable(a!.master.id, false);
    await world.pass(5_000);
    const extension = { resumeToken: phone.token!, sentMs: 1 };
    const back = await b!.register({ name: 'phone', id: phone.id, extension });
    expect(back.id).toBe(phone.id);
  });

  it('[CU-22] that went there and back again stay where they are', async () => {
    const [world, a, b] = await clusterOf(2);
    const phone = await a!.extension('phone');
    await world.pass();
    world.hub.cut(a!.master.id, b!.master.id);
    await world.pass(5_000);
    const as = { name: 'phone', id: phone.id, extension: { resumeToken: phone.token! } };
    const there = await b!.register(as);
    there.open();
    await world.pass(100);
    const back = await a!.register(as);
    back.open();
    world.hub.heal();
    await world.pass(5_000);
    expect(back.closed).toBeUndefined();
    expect(there.closed?.reason).toBe('superseded');
  });
});
