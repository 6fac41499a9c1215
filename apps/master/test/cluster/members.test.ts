import { describe, expect, it } from 'vitest';
import { decode } from '@ubii/proto';
import { clusterOf, ClusterWorld, publisherAndSubscriber } from './cluster-world.ts';
import { ProvenBus } from '../../src/core/cluster/proven-bus.ts';
import { PlainSeal, TestMaster } from '../../src/testing/index.ts';

describe('masters of a cluster', () => {
  it('[CU-1] [CU-2] [CU-5] hear of each other, and do not listen to other versions', async () => {
    const [world, a] = await clusterOf(2);
    const told: string[] = [];
    const future = world.hub.bus();
    future.listen('future', {
      handleMessage: (_from, bytes) => {
        const { proof: _proof, ...message } = decode('ubii.extension.ClusterMessage', bytes);
        told.push(Object.keys(message).find((key) => message[key as 'hello'] !== undefined)!);
      },
      handleReach() {},
    });
    const { clock } = world;
    const proven = { bus: future, seal: new PlainSeal(), id: 'future', clock, log: a!.log };
    new ProvenBus(proven).broadcast({ hello: { version: 99, name: 'future' } });
    await world.pass(3_000);
    expect(new Set(told)).toEqual(new Set(['hello']));
    const gauge = a!.master.metrics().find(({ name }) => name === 'ubii_cluster_masters');
    expect(gauge?.values[0]?.value).toBe(1);
  });

  it('[CU-40] measure what crosses, and a master that is alone has none of these metrics', async () => {
    const { world, a, b, publisher } = await publisherAndSubscriber();
    publisher.publish('/a', 'double', 1);
    await world.pass();
    const value = (master: TestMaster, metric: string): number | undefined =>
      master.master.metrics().find(({ name }) => name === `ubii_cluster_${metric}`)?.values[0]
        ?.value;
    expect([
      value(a, 'reachable'),
      value(a, 'records_sent_total'),
      value(b, 'records_received_total'),
      value(b, 'gaps_total'),
    ]).toEqual([1, 1, 1, 0]);
    const alone = new TestMaster();
    expect(value(alone, 'masters')).toBeUndefined();
  });

  it('[CU-16] say each for themselves who came and which masters there are', async () => {
    const world = new ClusterWorld();
    const a = await world.add();
    const b = await world.add();
    const page = await b.extension('page');
    await page.subscribe({ subscribeTopicRegexp: ['^/info/device/', '^/ubii/client/'] });
    await world.pass();
    page.takeRecords();
    await a.extension('phone', { devices: [{ name: 'sensor' }] });
    await world.pass();
    const topics = page.takeRecords().map(({ topic }) => topic);
    expect(topics.filter((topic) => topic === '/info/device/new')).toHaveLength(1);
    expect(world.crossed()).toBe(0);
  });

  it('[CU-33] keep what is open before they answer', async () => {
    const [world, a] = await clusterOf(1);
    const { session } = await a!.call({
      topic: '/services/session/runtime/add',
      session: { name: 'empty', processingModules: [] },
    });
    expect([...world.storage.running.documents().keys()]).toEqual([session!.id]);
  });
});
