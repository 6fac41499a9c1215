import { describe, expect, it } from 'vitest';
import { clusterOf, laterValues, publisherAndSubscriber } from './cluster-world.ts';

describe('values of topics in a cluster', () => {
  it('[CU-12] stand for subscribers that come later, at every master', async () => {
    const [world, a, b, c] = await clusterOf(3);
    const publisher = await a!.extension('publisher');
    publisher.publish('/a', 'double', 1);
    publisher.publish('/b', 'double', 2);
    for (const master of [b!, c!]) {
      const late = await master.extension('late');
      await late.subscribe({ subscribeTopicRegexp: ['/.*'] });
      await world.pass();
      expect(late.takeValues()).toEqual([
        ['/a', 1],
        ['/b', 2],
      ]);
      await late.subscribe({ subscribeTopics: ['/a'] });
      await world.pass();
      // The value again for the new subscription is the master's own: it has it.
      expect(late.takeValues()).toEqual([['/a', 1]]);
    }
  });

  it('[CU-12] are the newest of all masters, the same everywhere', async () => {
    const [world, a, b] = await clusterOf(2);
    const one = await a!.extension('one');
    const other = await b!.extension('other');
    one.publish('/a', 'double', 1);
    await world.pass();
    other.publish('/a', 'double', 2);
    await world.pass();
    for (const master of [a!, b!]) {
      expect((await laterValues(world, master)).at(-1)).toEqual(['/a', 2]);
    }
  });

  it('[CU-12] agree after both published in the same moment', async () => {
    const [world, a, b] = await clusterOf(2);
    const one = await a!.extension('one');
    const other = await b!.extension('other');
    await one.subscribe({ subscribeTopics: ['/a'] });
    await other.subscribe({ subscribeTopics: ['/a'] });
    await world.pass();
    one.publish('/a', 'double', 1);
    other.publish('/a', 'double', 2);
    await world.pass();
    // Each got both, and each has the same one in the end.
    expect(one.takeValues().sort()).toEqual(other.takeValues().sort());
    const values: unknown[] = [];
    for (const master of [a!, b!]) {
      values.push((await laterValues(world, master)).at(-1));
    }
    expect(values[0]).toEqual(['/a', expect.any(Number)]);
    expect(values[0]).toEqual(values[1]);
  });

  it('[CU-13] are not kept at a master without subscribers', async () => {
    const { world, publisher, subscriber } = await publisherAndSubscriber();
    publisher.publish('/a', 'double', 1);
    await world.pass();
    await subscriber.subscribe({ unsubscribeTopics: ['/a'] });
    await world.pass();
    subscriber.takeValues();
    publisher.publish('/a', 'double', 2);
    await world.pass();
    await subscriber.subscribe({ subscribeTopics: ['/a'] });
    await world.pass();
    expect(subscriber.takeValues()).toEqual([['/a', 2]]);
  });

  it('[CU-14] end where they came from, for those that have them', async () => {
    const { world, b, publisher } = await publisherAndSubscriber();
    publisher.publish('/a', 'double', 1);
    await world.pass();
    publisher.drop('left');
    await world.pass();
    expect(await laterValues(world, b)).toEqual([]);
  });

  it('[CU-14] end when their master stays away', async () => {
    const { world, a, b, publisher } = await publisherAndSubscriber();
    publisher.publish('/a', 'double', 1);
    await world.pass();
    world.hub.setReachable(a.master.id, false);
    await world.pass(20_000);
    expect(await laterValues(world, b)).toEqual([]);
  });

  it('[TD-19] belong to the client here that publishes after another master', async () => {
    const [world, a, b] = await clusterOf(2);
    const one = await a!.extension('one');
    const other = await b!.extension('other');
    await other.subscribe({ subscribeTopics: ['/a'] });
    await world.pass();
    one.publish('/a', 'double', 1);
    await world.pass();
    other.publish('/a', 'double', 2);
    await world.pass();
    one.drop('left');
    await world.pass();
    other.takeValues();
    expect(await laterValues(world, b!)).toEqual([['/a', 2]]);
    other.drop('left');
    await world.pass();
    expect(await laterValues(world, b!)).toEqual([]);
  });

  it('[CU-14] end also for those that get only so many records a second', async () => {
    const [world, a, b] = await clusterOf(2);
    const publisher = await a!.extension('publisher');
    const slow = await b!.extension('slow');
    await slow.subscribe({ subscribeTopics: ['/a'], maxRateHz: 5 });
    await world.pass();
    publisher.publish('/a', 'double', 1);
    await world.pass(500);
    publisher.drop('left');
    await world.pass();
    expect(await laterValues(world, b!)).toEqual([]);
  });

  it('[CU-14] stay when a device of a client here that names their topic goes', async () => {
    const [world, a, b] = await clusterOf(2);
    const publisher = await a!.extension('publisher');
    const other = await b!.extension('other', {
      devices: [{ name: 'copy', components: [{ topic: '/a' }] }],
    });
    await other.subscribe({ subscribeTopics: ['/a'] });
    publisher.publish('/a', 'double', 1);
    await world.pass();
    await other.call({
      topic: '/services/device/deregistration',
      device: { id: other.registered.devices[0]!.id, clientId: other.id },
    });
    expect(await laterValues(world, b!)).toEqual([['/a', 1]]);
  });

  it('[CU-7] are not interrupted when masters lose each other for a moment', async () => {
    const { world, a, b, publisher, subscriber } = await publisherAndSubscriber();
    publisher.publish('/a', 'double', 1);
    await world.pass();
    subscriber.takeValues();
    world.hub.cut(a.master.id, b.master.id);
    await world.pass(4_000);
    world.hub.heal();
    await world.pass(6_000);
    // Neither an end of the value nor the value again.
    expect(subscriber.takeRecords()).toEqual([]);
  });
});
