import { describe, expect, it } from 'vitest';
import { clusterOf, publisherAndSubscriber } from './cluster-world.ts';

describe('records of another master', () => {
  it('[CU-10] reach its subscribers, once and in order', async () => {
    const { world, publisher, subscriber } = await publisherAndSubscriber();
    for (let i = 0; i < 5; i++) publisher.publish('/a', 'double', i);
    publisher.send('/a', 'double', 5);
    publisher.send('/a', 'double', 6);
    await world.pass();
    expect(subscriber.takeValues()).toEqual([0, 1, 2, 3, 4, 5, 6].map((i) => ['/a', i]));
  });

  it('[CU-10] do not leave the master without subscribers elsewhere', async () => {
    const [world, a] = await clusterOf(3);
    const publisher = await a!.extension('publisher');
    const own = await a!.extension('own');
    await own.subscribe({ subscribeTopics: ['/a'] });
    await world.pass();
    publisher.publish('/a', 'double', 1);
    await world.pass();
    expect(own.takeValues()).toEqual([['/a', 1]]);
    expect(world.crossed()).toBe(0);
  });

  it('[CU-10] cross by regular expression, by component profile and for those that watch everything', async () => {
    const [world, a, b] = await clusterOf(2);
    const publisher = await a!.extension('publisher', {
      devices: [
        {
          name: 'thermometer',
          components: [{ topic: '/room/1', messageFormat: 'double', tags: ['temperature'] }],
        },
      ],
    });
    const byPattern = await b!.extension('by pattern');
    const byProfile = await b!.extension('by profile');
    const watcher = await b!.extension('watcher', {
      devices: [{ name: 'monitor', deviceType: 1 }],
    });
    await byPattern.subscribe({ subscribeTopicRegexp: ['/room/.*'] });
    await byProfile.subscribe({ subscribeComponents: [{ tags: ['temperature'] }] });
    await world.pass();
    for (const client of [byPattern, byProfile, watcher]) client.takeValues();
    publisher.publish('/room/1', 'double', 21);
    publisher.publish('/hall', 'double', 18);
    await world.pass();
    expect(byPattern.takeValues()).toEqual([['/room/1', 21]]);
    expect(byProfile.takeValues()).toEqual([['/room/1', 21]]);
    const values = watcher.takeValues().filter(([topic]) => !topic.startsWith('/ubii/'));
    expect(values).toEqual([
      ['/room/1', 21],
      ['/hall', 18],
    ]);
  });

  it('[CU-11] go no further, and do not come back', async () => {
    const [world, a, b, c] = await clusterOf(3);
    const clients = await Promise.all([a!, b!, c!].map((master) => master.extension('one')));
    for (const client of clients) await client.subscribe({ subscribeTopics: ['/a'] });
    await world.pass();
    clients[0]!.publish('/a', 'double', 1);
    await world.pass();
    clients[1]!.publish('/a', 'double', 2);
    await world.pass();
    for (const client of clients) {
      expect(client.takeValues()).toEqual([
        ['/a', 1],
        ['/a', 2],
      ]);
    }
    expect(world.crossed()).toBe(4);
  });

  it('[CU-10] cross no faster than the fastest of those that want them', async () => {
    const [world, a, b] = await clusterOf(2);
    const publisher = await a!.extension('camera');
    const slow = await b!.extension('slow');
    const faster = await b!.extension('faster');
    await slow.subscribe({ subscribeTopics: ['/a'], maxRateHz: 5 });
    await faster.subscribe({ subscribeTopics: ['/a'], maxRateHz: 10 });
    await world.pass();
    for (let i = 0; i < 100; i++) {
      publisher.publish('/a', 'double', i);
      await world.pass(10);
    }
    expect(world.crossed()).toBeGreaterThan(8);
    expect(world.crossed()).toBeLessThan(13);
    expect(faster.takeValues().length).toBeGreaterThan(slow.takeValues().length);
  });

  it('[CU-10] stop when the last one that wants them is gone', async () => {
    const [world, a, b] = await clusterOf(2);
    const publisher = await a!.extension('publisher');
    const subscriber = await b!.extension('subscriber');
    await subscriber.subscribe({ subscribeTopics: ['/a'], subscribeTopicRegexp: ['/b.*'] });
    await world.pass();
    await subscriber.subscribe({ unsubscribeTopics: ['/a'] });
    await world.pass();
    publisher.publish('/a', 'double', 1);
    publisher.publish('/b', 'double', 2);
    await world.pass();
    expect(subscriber.takeValues()).toEqual([['/b', 2]]);
    subscriber.drop('left');
    await world.pass();
    publisher.publish('/b', 'double', 3);
    await world.pass();
    expect(world.crossed()).toBe(1);
  });
});
