import { AccessRole, type TopicSubscribers } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { createGrant, join } from './access-world.ts';

const SEE = {
  name: 'see',
  inputs: [{ internalName: 'image', messageFormat: 'double' }],
  processingMode: { triggerOnInput: {} },
  onProcessingStringified: '() => ({})',
};

async function createWorld() {
  const master = new TestMaster();
  const ada = await master.extension('ada');
  const ben = await master.legacy('ben');
  const topic = `/${ada.id}/camera/image`;
  const ask = async (client: TestClient, ...topics: string[]) => {
    const { topicSubscribersList, error } = await client.call({
      topic: '/services/ubii/topic_subscribers',
      topicSubscribersRequest: { topics },
    });
    return { elements: topicSubscribersList?.elements, error };
  };
  const who = async (client: TestClient = ada): Promise<TopicSubscribers> =>
    (await ask(client, topic)).elements![0]!;
  return { master, ada, ben, topic, ask, who };
}

describe('subscribers of a topic', () => {
  it('are listed, each client once, however it subscribed [EX-95]', async () => {
    const { master, ada, ben, topic, ask, who } = await createWorld();
    expect(await who()).toEqual({ topic, count: 0, clientIds: [], modules: [] });
    await ben.subscribe({ subscribeTopics: [topic], subscribeTopicRegexp: ['image$'] });
    const cleo = await master.extension('cleo');
    await cleo.subscribe({ subscribeTopicRegexp: ['^/.*/camera/'] });
    await ada.subscribe({ subscribeTopics: ['/other'] });
    ada.publish(topic, 'double', 1);
    expect((await who()).clientIds.sort()).toEqual([ben.id, cleo.id].sort());
    const { elements } = await ask(ada, '/none', '/other');
    expect(elements!.map(({ count }) => count)).toEqual([0, 1]);
    await ben.subscribe({ unsubscribeTopics: [topic], unsubscribeTopicRegexp: ['image$'] });
    expect(await who()).toMatchObject({ count: 1, clientIds: [cleo.id] });
  });

  it('are clients with a socket; a client without one receives nothing until it reconnects [EX-95]', async () => {
    const { ben, topic, ada, who } = await createWorld();
    await ben.subscribe({ subscribeTopics: [topic] });
    ada.publish(topic, 'double', 1);
    expect(await who()).toMatchObject({ count: 1, clientIds: [ben.id] });
    ben.drop();
    expect(await who()).toMatchObject({ count: 0, clientIds: [] });
  });

  it('are listed with the modules that get it, by topic and by muxer [EX-97]', async () => {
    const { master, ada, topic, who } = await createWorld();
    const start = async (name: string, input: object) => {
      const { session, error } = await ada.call({
        topic: '/services/session/runtime/start',
        session: {
          name,
          processingModules: [SEE],
          ioMappings: [
            { processingModuleName: 'see', inputMappings: [{ inputName: 'image', ...input }] },
          ],
        },
      });
      expect(error).toBeUndefined();
      return session!;
    };
    ada.publish(topic, 'double', 1);
    const byTopic = await start('by topic', { topic });
    await start('another topic', { topic: '/other' });
    const byMuxer = await start('by muxer', {
      topicMux: { topicGlob: '/*/camera/image', identityMatchPattern: '^/([^/]+)' },
    });
    await master.pass(50);
    const { modules, clientIds, count } = await who();
    const [masterId] = clientIds;
    expect(count).toBe(1);
    const see = { name: 'see', nodeId: masterId };
    expect(modules).toEqual([
      { ...see, sessionId: byTopic.id, sessionName: 'by topic' },
      { ...see, sessionId: byMuxer.id, sessionName: 'by muxer' },
    ]);
    for (const { id } of [byTopic, byMuxer]) {
      await ada.call({ topic: '/services/session/runtime/stop', session: { id } });
    }
    await master.pass(50);
    expect(await who()).toMatchObject({ count: 0, modules: [] });
  });

  it('are a number for players, and of their own topics only [EX-96]', async () => {
    const { master, ada, ben, topic, ask } = await createWorld();
    const { token } = await createGrant(master, AccessRole.ACCESS_ROLE_PLAYER);
    const player = await join(master, token);
    const own = `/${player.id}/camera/image`;
    await ben.subscribe({ subscribeTopics: [own, topic] });
    expect((await ask(player, own)).elements).toEqual([
      { topic: own, count: 1, clientIds: [], modules: [] },
    ]);
    expect((await ask(player, own, topic)).error).toMatchObject({ code: 'permission_denied' });
    expect((await ask(ada, own)).elements![0]!.clientIds).toEqual([ben.id]);
  });

  it('are listed for at most 16 topics at once [EX-95]', async () => {
    const { ada, ask } = await createWorld();
    const topics = Array.from({ length: 17 }, (_, i) => `/${i}`);
    expect((await ask(ada, ...topics)).error).toMatchObject({ code: 'invalid_argument' });
  });
});
