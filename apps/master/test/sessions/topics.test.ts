import { SessionState, type Init, type Session } from '@ubii/proto';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import { describe, expect, it } from 'vitest';
import { codes, doubling, SessionWorld, TOPICS } from './session-world.ts';
import { TestNode } from './test-node.ts';

const LIMITS = { topicsPerClient: 100, topicsPerSession: 20, topicsPerModule: 10 };

/** Puts out `perRun` elements on topics that no run before had, whenever something comes. */
function demuxing(name: string, perRun: number, outputTopicFormat = `/${name}/{{#0}}`) {
  return {
    name,
    processingModules: [
      {
        name,
        inputs: [{ internalName: 'in', messageFormat: 'double' }],
        outputs: [{ internalName: 'out', messageFormat: 'double' }],
        processingMode: { triggerOnInput: {} },
        onCreatedStringified: '(state) => { state.count = 0; }',
        onProcessingStringified: `(deltaTime, inputs, state) => inputs.in ? ({ outputs: { out: { elements:
          Array.from({ length: ${perRun} }, () => ({ double: 1, outputTopicParams: [String(state.count++)] })) } } }) : {}`,
      },
    ],
    ioMappings: [
      {
        processingModuleName: name,
        inputMappings: [{ inputName: 'in', topic: '/go' }],
        outputMappings: [{ outputName: 'out', topicDemux: { outputTopicFormat } }],
      },
    ],
  } satisfies Init<Session>;
}

async function createWorld(limits: Record<string, number> = LIMITS) {
  const world = await SessionWorld.create({ limits });
  const go = async (times = 1): Promise<void> => {
    for (let i = 0; i < times; i++) {
      world.ada.publish('/go', 'double', i);
      await world.master.pass(20);
    }
  };
  const topics = async (): Promise<string[]> => {
    const { stringList } = await world.master.call({ topic: '/services/topic_list' });
    return stringList!.elements.filter((topic) => !/^\/(services|info|go$)/.test(topic));
  };
  return { world, go, topics };
}

describe('topics of the modules of a session', () => {
  it('leave room for other sessions when a demuxer makes more and more of them [SE-60]', async () => {
    const { world, go, topics } = await createWorld();
    for (const name of ['one', 'two', 'three']) await world.ask(TOPICS.start, demuxing(name, 5));
    await go(30);
    expect(await topics()).toHaveLength(30);
    await world.ask(TOPICS.start, doubling('/go', '/doubled'));
    await go(3);
    expect(await world.value('/doubled')).toBe(4);
  });

  it('are refused beyond a number of one module, which is named while the others go on [SE-61]', async () => {
    const { world, go, topics } = await createWorld();
    const session = await world.ask(TOPICS.start, demuxing('runaway', 5));
    await world.ada.subscribe({ subscribeTopics: [`/ubii/session/${session.id}/events`] });
    await world.master.pass(2000);
    world.takeNews();
    await go(10);
    await world.master.pass(2000);
    expect(await topics()).toHaveLength(10);
    const [problem] = (await world.get(session)).extension!.problems;
    expect(problem).toMatchObject({
      code: 'too_many_topics',
      isError: false,
      moduleId: session.processingModules[0]!.id,
    });
    expect(problem!.message).toMatch(
      /output "out" of the module "runaway" in the session "runaway" .* it has 10, and \d+ more a second are refused/,
    );
    const { masterStatus } = await world.master.call({
      topic: '/services/ubii/master_status',
      masterStatusRequest: {},
    });
    expect(masterStatus!.events.map(({ text }) => text)).toContainEqual(
      expect.stringContaining('module "runaway" in the session "runaway"'),
    );
    expect(masterStatus!.problems.map(({ code }) => code)).toContain('limit_reached');
    // Topics that are there are still written.
    expect((await world.get(session)).extension?.state).toBe(SessionState.SESSION_RUNNING);
    await world.master.pass(40_000);
    const { problems } = (await world.get(session)).extension!;
    expect(codes(problems)).not.toContain('too_many_topics');
  });

  it('are refused beyond a number of one session [SE-61]', async () => {
    const { world, go, topics } = await createWorld();
    const [one, two, three] = ['one', 'two', 'three'].map((name) => demuxing(name, 10));
    await world.ask(TOPICS.start, {
      name: 'all',
      processingModules: [one, two, three].flatMap((part) => part!.processingModules),
      ioMappings: [one, two, three].flatMap((part) => part!.ioMappings),
    });
    await go();
    expect(await topics()).toHaveLength(20);
  });

  it('end when they were not written for a minute [SE-61]', async () => {
    const { world, go, topics } = await createWorld();
    await world.ask(TOPICS.start, demuxing('runaway', 5));
    await go(2);
    await world.master.pass(60_000);
    await go();
    expect(await topics()).toEqual(
      [5, 6, 7, 8, 9, 10, 11, 12, 13, 14].map((number) => `/runaway/${number}`),
    );
  });

  it('end when the session stops, those of plain mappings when it is removed [SE-62]', async () => {
    const { world, go, topics } = await createWorld();
    const demuxed = await world.ask(TOPICS.start, demuxing('demuxed', 5));
    const plain = await world.ask(TOPICS.start, doubling('/go', '/plain'));
    await go(2);
    expect(await topics()).toHaveLength(11);
    for (const { id } of [demuxed, plain]) await world.ask(TOPICS.stop, { id });
    expect(await topics()).toEqual(['/plain']);
    await world.ask(TOPICS.remove, { id: plain.id });
    expect(await topics()).toEqual([]);
    // The same again: nothing was kept.
    await world.ask(TOPICS.start, demuxing('again', 10));
    await go();
    expect(await topics()).toHaveLength(10);
  });

  it('end with a running session that is removed, whatever its modules still put out [SE-62]', async () => {
    const { world, go, topics } = await createWorld();
    const { id } = await world.ask(TOPICS.start, demuxing('demuxed', 5));
    await go();
    world.ada.publish('/go', 'double', 1);
    await world.ask(TOPICS.remove, { id });
    await world.master.pass(100);
    expect(await topics()).toEqual([]);
  });

  it('end when an update takes their mapping away [SE-62]', async () => {
    const { world, go, topics } = await createWorld();
    const session = await world.ask(TOPICS.start, doubling('/go', '/before'));
    await go();
    const after = doubling('/go', '/after').ioMappings!;
    const { id, processingModules } = session;
    await world.ask(TOPICS.update, {
      id,
      name: 'doubling',
      processingModules,
      ioMappings: [{ ...after[0], processingModuleId: processingModules[0]!.id }],
    });
    await go();
    expect(await topics()).toEqual(['/after']);
  });

  it('end with the last of the modules that write them [SE-62]', async () => {
    const { world, go, topics } = await createWorld();
    const [one, two] = ['one', 'two'].map((name) => demuxing(name, 1, '/both/{{#0}}'));
    const { id, processingModules, ioMappings } = await world.ask(TOPICS.start, {
      name: 'both',
      processingModules: [one, two].flatMap((part) => part!.processingModules),
      ioMappings: [one, two].flatMap((part) => part!.ioMappings),
    });
    await go();
    expect(await topics()).toEqual(['/both/0']);
    await world.ask(TOPICS.update, {
      id,
      name: 'both',
      processingModules: processingModules.slice(1),
      ioMappings: ioMappings.slice(1),
    });
    expect(await topics()).toEqual(['/both/0']);
    await world.ask(TOPICS.stop, { id });
    expect(await topics()).toEqual([]);
  });

  it('leave topics of clients alone [SE-62]', async () => {
    const { world, go, topics } = await createWorld();
    world.ada.publish('/demuxed/0', 'double', 7);
    const { id } = await world.ask(TOPICS.start, demuxing('demuxed', 2));
    await go();
    await world.ask(TOPICS.remove, { id });
    expect(await topics()).toEqual(['/demuxed/0']);
  });

  it('end on a node when it says so, but for topics of others [SE-63]', async () => {
    const { world, topics } = await createWorld();
    const node = await TestNode.ours(world.master, 'node');
    node.client.publish('/of/node', 'double', 1);
    world.ada.publish('/of/ada', 'double', 1);
    node.client.socket.handleTopicData(
      encodeNodeMessageFrame({ endedTopics: { topics: ['/of/node', '/of/ada', '/none'] } }),
    );
    expect(await topics()).toEqual(['/of/ada']);
  });
});
