import { describe, expect, it } from 'vitest';
import { clusterOf, publisherAndSubscriber } from './cluster-world.ts';

describe('what masters tell each other', () => {
  it('[CU-7] is told again from the start when something of it is missing', async () => {
    const [world, a, b] = await clusterOf(2);
    const publisher = await a!.extension('publisher');
    const subscriber = await b!.extension('subscriber');
    await subscriber.subscribe({ subscribeTopics: ['/a', '/b'] });
    await world.pass();
    publisher.publish('/b', 'double', 0);
    await world.pass();
    subscriber.takeValues();
    world.hub.lose(1);
    publisher.publish('/a', 'double', 1);
    publisher.publish('/a', 'double', 2);
    await world.pass(2_000);
    // The value that is there again, and nothing twice.
    expect(subscriber.takeValues()).toEqual([['/a', 2]]);
    publisher.publish('/a', 'double', 3);
    await world.pass();
    expect(subscriber.takeValues()).toEqual([['/a', 3]]);
  });

  it('[CU-7] catches up on clients that left, values that ended and interest that ended', async () => {
    const [world, a, b] = await clusterOf(2);
    const publisher = await a!.extension('publisher');
    const other = await a!.extension('other');
    const subscriber = await b!.extension('subscriber');
    await subscriber.subscribe({ subscribeTopics: ['/a', '/b'] });
    await world.pass();
    publisher.publish('/a', 'double', 1);
    other.publish('/b', 'double', 1);
    await world.pass();
    world.hub.lose(100);
    other.drop('left');
    await subscriber.subscribe({ unsubscribeTopics: ['/a'] });
    await world.pass(100);
    world.hub.loseNothing();
    await world.pass(3_000);
    const { clientList } = await b!.call({ topic: '/services/client/get_list', clientList: {} });
    expect(clientList?.elements.map(({ name }) => name).sort()).toEqual([
      'publisher',
      'subscriber',
    ]);
    const late = await b!.extension('late');
    await late.subscribe({ subscribeTopics: ['/b'] });
    expect(late.takeValues()).toEqual([]);
    const crossed = world.crossed();
    publisher.publish('/a', 'double', 2);
    await world.pass();
    expect(world.crossed()).toBe(crossed);
  });

  it('[CU-6] comes in full after the bus was away', async () => {
    const { world, a, b, publisher, subscriber } = await publisherAndSubscriber();
    for (const master of [a, b]) world.hub.setReachable(master.master.id, false);
    publisher.publish('/a', 'double', 1);
    await world.pass(8_000);
    for (const master of [a, b]) world.hub.setReachable(master.master.id, true);
    await world.pass(2_000);
    expect(subscriber.takeValues()).toEqual([['/a', 1]]);
  });

  it('[CU-3] ends at once when a master says that it ends', async () => {
    const { world, a, b, publisher } = await publisherAndSubscriber();
    await a.master.close();
    await world.pass(20);
    const { clientList } = await b.call({ topic: '/services/client/get_list', clientList: {} });
    const gone = clientList?.elements.find(({ name }) => name === 'publisher');
    expect([publisher.id, 1]).toEqual([gone?.id, gone?.state]);
  });

  it('[CU-8] goes on after a message that cannot be read', async () => {
    const [world, a, b] = await clusterOf(2);
    const stranger = world.hub.bus();
    stranger.listen('stranger', { handleMessage() {}, handleReach() {} });
    stranger.broadcast(Uint8Array.of(255, 255, 255));
    stranger.send(a!.master.id, Uint8Array.of(0x22, 200));
    await world.pass();
    const subscriber = await b!.extension('subscriber');
    await subscriber.subscribe({ subscribeTopics: ['/a'] });
    await world.pass();
    const publisher = await a!.extension('publisher');
    publisher.publish('/a', 'double', 1);
    await world.pass();
    expect(subscriber.takeValues()).toEqual([['/a', 1]]);
  });
});
