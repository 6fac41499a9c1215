import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import { SessionState } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { doubler, doubling, TOPICS } from '../sessions/session-world.ts';
import { clusterOf } from './cluster-world.ts';

describe('nodes of a cluster', () => {
  it('[CU-24] run modules of sessions of another master', async () => {
    const [world, a, b] = await clusterOf(2);
    const node = await b!.extension('node', {
      extension: { recordLists: true, node: { kind: 2, runsJavascript: true, acceptsWork: true } },
    });
    await node.subscribe({ subscribeTopicRegexp: ['^/info/session/'] });
    await world.pass();
    const { nodeList } = await a!.call({ topic: TOPICS.nodes });
    expect(nodeList?.elements.find(({ clientId }) => clientId === node.id)?.available).toBe(true);

    const session = {
      ...doubling('/in', '/out'),
      processingModules: [{ ...doubler, nodeId: node.id }],
    };
    const started = await a!.call({ topic: TOPICS.start, session });
    await world.pass();
    const { id, processingModules } = started.session!;
    const [module] = processingModules;
    const told = node.takeRecords().filter(({ topic }) => topic === '/info/session/start');
    expect(told).toHaveLength(1);

    const replied = node.call({
      topic: TOPICS.ran,
      processingModuleList: { elements: [{ id: module!.id, nodeId: node.id }] },
    });
    await world.pass();
    expect((await replied).success).toBeDefined();
    const state = async () => {
      const { sessionList } = await a!.call({ topic: TOPICS.list });
      return sessionList?.elements.find((one) => one.id === id)?.extension?.state;
    };
    expect(await state()).toBe(SessionState.SESSION_RUNNING);

    // What it says of its modules reaches the master of the session.
    const page = await a!.extension('page');
    await page.subscribe({ subscribeTopicRegexp: ['^/ubii/session/.*/events'] });
    await world.pass();
    node.socket.handleTopicData(
      encodeNodeMessageFrame({
        moduleReports: { events: [{ moduleId: module!.id, message: 'hello', kind: 2 }] },
      }),
    );
    await world.pass();
    const events = page.takeRecords().map(({ value }) => JSON.stringify(value));
    expect(events.join()).toContain('hello');
  });
});
