import type { Init, ServiceReply, ServiceRequest } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import type { TestClient } from '../../src/testing/index.ts';
import { clusterOf, type ClusterWorld } from './cluster-world.ts';

/** Asks, and lets other masters add what they have. */
async function ask(
  world: ClusterWorld,
  client: TestClient,
  request: Init<ServiceRequest>,
): Promise<ServiceReply> {
  const replied = client.call(request);
  await world.pass(20);
  return replied;
}

describe('lists of a cluster', () => {
  it('[CU-29] have the topics of every master, with their counters', async () => {
    const [world, a, b] = await clusterOf(2);
    const robot = await a!.extension('robot');
    const page = await b!.extension('page');
    robot.publish('/at-a', 'double', 1);
    robot.publish('/at-a', 'double', 2);
    page.publish('/at-b', 'double', 1);
    const { stringList } = await ask(world, page, { topic: '/services/topic_list' });
    expect(stringList?.elements).toEqual(expect.arrayContaining(['/at-a', '/at-b']));

    const statistics = async (cursor: number) => {
      await world.pass(500);
      const reply = await ask(world, page, {
        topic: '/services/ubii/topic_statistics',
        topicStatisticsRequest: { cursor },
      });
      return reply.topicStatistics!;
    };
    const first = await statistics(0);
    const found = first.elements.find(({ topic }) => topic === '/at-a');
    expect([found?.records, found?.publisherId, found?.subscribers]).toEqual([2, robot.id, 0]);

    await page.subscribe({ subscribeTopics: ['/at-a'] });
    const other = await a!.extension('other');
    await other.subscribe({ subscribeTopics: ['/at-a'] });
    await world.pass();
    robot.publish('/at-a', 'double', 3);
    await world.pass();
    const second = await statistics(first.cursor);
    const changed = second.elements.find(({ topic }) => topic === '/at-a');
    expect([changed?.records, changed?.subscribers]).toEqual([3, 2]);
    expect((await statistics(second.cursor)).elements.map(({ topic }) => topic)).not.toContain(
      '/at-a',
    );

    await page.subscribe({ unsubscribeTopics: ['/at-a'] });
    await other.subscribe({ unsubscribeTopics: ['/at-a'] });
    robot.drop('left');
    await world.pass();
    const third = await statistics(second.cursor);
    expect(third.removed).toContain('/at-a');
  });

  it('[CU-29] have what the clients of every master do, and who gets a topic', async () => {
    const [world, a, b] = await clusterOf(2);
    const robot = await a!.extension('robot');
    const page = await b!.extension('page');
    await robot.subscribe({ subscribeTopics: ['/t'] });
    await page.subscribe({ subscribeTopics: ['/t'] });
    await world.pass();
    const { clientReport } = await ask(world, page, {
      topic: '/services/ubii/client_report',
      clientReportRequest: {},
    });
    const told = clientReport!.clients.map(({ clientId, connected }) => [clientId, connected]);
    expect(told.sort()).toEqual(
      [
        [page.id, true],
        [robot.id, true],
      ].sort(),
    );
    const { topicSubscribersList } = await ask(world, page, {
      topic: '/services/ubii/topic_subscribers',
      topicSubscribersRequest: { topics: ['/t'] },
    });
    const [subscribers] = topicSubscribersList!.elements;
    expect(subscribers?.count).toBe(2);
    expect([...subscribers!.clientIds].sort()).toEqual([page.id, robot.id].sort());
  });

  it('[CU-29] do without a master that does not answer', async () => {
    const [world, a, b] = await clusterOf(2);
    const page = await b!.extension('page');
    world.hub.cut(a!.master.id, b!.master.id);
    const replied = page.call({ topic: '/services/topic_list' });
    await world.pass(1_100);
    expect((await replied).stringList?.elements.length).toBeGreaterThan(10);
  });
});
