import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';

async function createPair() {
  const master = new TestMaster();
  const ada = await master.legacy('ada');
  const ben = await master.legacy('ben');
  const topics = async (): Promise<string[]> => {
    const { stringList } = await master.call({ topic: '/services/topic_list' });
    return stringList!.elements.filter((topic) => !/^\/(services|info)\//.test(topic));
  };
  return { master, ada, ben, topics };
}

async function registerPen(client: TestClient, topics: string[], ioType: 0 | 1 = 0) {
  const { device } = await client.call({
    topic: '/services/device/registration',
    device: { clientId: client.id, components: topics.map((topic) => ({ topic, ioType })) },
  });
  return device!;
}

describe('topics that end', () => {
  it('lose their values when their client is deregistered [TD-40]', async () => {
    const { ada, ben, topics } = await createPair();
    ada.publish('/a', 'double', 1);
    ben.publish('/b', 'double', 2);
    await ada.call({ topic: '/services/client/deregistration', client: { id: ada.id } });
    expect(await topics()).toEqual(['/b']);
  });

  it('lose their values when their client becomes unavailable [TD-40]', async () => {
    const { master, ada, topics } = await createPair();
    ada.publish('/a', 'double', 1);
    ada.drop();
    master.clock.advanceSync(9_000);
    expect(await topics()).toEqual(['/a']);
    master.clock.advanceSync(1_000);
    expect(await topics()).toEqual([]);
  });

  it('lose their values when the device that publishes them is deregistered [TD-40] [DV-4]', async () => {
    const { ada, topics } = await createPair();
    const device = await registerPen(ada, ['/pen', '/pen/pressure']);
    for (const topic of ['/pen', '/pen/pressure', '/other']) ada.publish(topic, 'double', 1);
    await ada.call({ topic: '/services/device/deregistration', device });
    expect(await topics()).toEqual(['/other']);
  });

  it('keep their values when a device that only reads them is deregistered [TD-40]', async () => {
    const { ada, topics } = await createPair();
    const device = await registerPen(ada, ['/pen'], 1);
    ada.publish('/pen', 'double', 1);
    await ada.call({ topic: '/services/device/deregistration', device });
    expect(await topics()).toEqual(['/pen']);
  });

  it('keep their values when a stranger names them in a device [TD-40]', async () => {
    const { master, ada, ben, topics } = await createPair();
    ada.publish('/a', 'double', 1);
    const device = await registerPen(ben, ['/a', '/info/device/new']);
    await ben.call({ topic: '/services/device/deregistration', device });
    expect(await topics()).toEqual(['/a']);
    const { stringList } = await master.call({ topic: '/services/topic_list' });
    expect(stringList!.elements).toContain('/info/device/new');
  });

  it('are sent only to nodes that use them, in order [TD-42]', async () => {
    const { master, ada, ben } = await createPair();
    const node = await master.extension('node', {
      extension: { recordLists: true, node: { runsJavascript: true } },
    });
    const plain = await master.extension('plain');
    for (const client of [node, plain, ben]) {
      await client.subscribe({ subscribeTopics: ['/a'], subscribeTopicRegexp: ['^/a'] });
    }
    ada.publish('/a', 'double', 1);
    ada.send('/a', 'double', 2);
    await ada.call({ topic: '/services/client/deregistration', client: { id: ada.id } });
    ben.publish('/a', 'double', 3);
    expect(node.takeValues()).toEqual([
      ['/a', 1],
      ['/a', 2],
      ['/a', undefined],
      ['/a', 3],
    ]);
    for (const client of [plain, ben]) {
      expect(client.takeValues()).toEqual([
        ['/a', 1],
        ['/a', 2],
        ['/a', 3],
      ]);
    }
  });

  it('are forgotten without value and without subscription [TD-41]', async () => {
    const { master, ada, ben } = await createPair();
    const known = async () => {
      const { topicStatistics } = await master.call({
        topic: '/services/ubii/topic_statistics',
        topicStatisticsRequest: {},
      });
      return topicStatistics!.elements.map(({ topic }) => topic);
    };
    await ben.subscribe({ subscribeTopics: ['/a', '/b'], subscribeTopicRegexp: ['.*'] });
    expect(await known()).toEqual(['/a', '/b']);
    ada.publish('/a', 'double', 1);
    await ben.subscribe({ unsubscribeTopics: ['/a', '/b'] });
    expect(await known()).toEqual(['/a']);
    await ada.call({ topic: '/services/client/deregistration', client: { id: ada.id } });
    expect(await known()).toEqual([]);
    // The pattern finds it when it comes again.
    const cleo = await master.legacy('cleo');
    cleo.publish('/a', 'double', 2);
    expect(ben.takeValues().at(-1)).toEqual(['/a', 2]);
  });
});
