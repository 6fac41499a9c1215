import {
  decodeTopicData,
  encodeRecord,
  SessionState,
  type Init,
  type ProcessingModule,
  type Session,
} from '@ubii/proto';
import { encodeLockstepReplyFrame } from '@ubii/proto/wire';
import { describe, expect, it } from 'vitest';
import { codes, doubler, SessionWorld, TOPICS } from './session-world.ts';
import { TestNode } from './test-node.ts';

/** One pass at 10 Hz. */
const PASS_MS = 100;

/** A lockstep module that puts out the sum of its input and its own number. */
function adder(name: string, nodeId = ''): Init<ProcessingModule> {
  return {
    ...doubler,
    name,
    nodeId,
    processingMode: { lockstep: {} },
    onProcessingStringified:
      '(dt, inputs) => ({ outputs: { out: { double: (inputs.in ? inputs.in.double : 0) + dt } } })',
  };
}

function lockstep(modules: readonly Init<ProcessingModule>[]): Init<Session> {
  return {
    name: 'lockstep',
    processingModules: modules,
    ioMappings: modules.map(({ name }) => ({
      processingModuleName: name,
      inputMappings: [{ inputName: 'in', topic: '/in' }],
      outputMappings: [{ outputName: 'out', topic: `/out/${name}` }],
    })),
    extension: { lockstepHertz: 1000 / PASS_MS },
  };
}

/** Requests for passes a node got since it was asked last. */
function takeRequests(node: TestNode) {
  return node.client.takeSent().flatMap((sent) => {
    if (sent.kind !== 'frame') return [];
    const [message] = decodeTopicData(sent.frame).nodeMessages;
    const request = message?.lockstepRequest;
    return request === undefined ? [] : [request];
  });
}

function answer(node: TestNode, request: ReturnType<typeof takeRequests>[number], value: number) {
  const topics = request.processingModuleIds.map(() => `/out/${node.client.name}`);
  node.client.socket.handleTopicData(
    encodeLockstepReplyFrame(
      {
        processingModuleIds: request.processingModuleIds,
        pass: request.pass,
        sessionId: request.sessionId,
      },
      topics.map((topic) => encodeRecord({ topic, format: 'double', value })),
    ),
  );
}

/** The master and two nodes, each with one module, all running. */
async function setup() {
  const world = await SessionWorld.create();
  const east = await TestNode.ours(world.master, 'east');
  const west = await TestNode.ours(world.master, 'west');
  await world.ada.subscribe({ subscribeTopicRegexp: ['^/out/'] });
  world.ada.publish('/in', 'double', 7);
  const session = await world.ask(
    TOPICS.start,
    lockstep([adder('west', west.id), adder('here'), adder('east', east.id)]),
  );
  for (const node of [east, west]) await node.ran(node.own(node.told('start')));
  world.ada.takeSent();
  return { world, east, west, session };
}

describe('lockstep', () => {
  it('runs all modules on one snapshot, and publishes all outputs together [SE-40] [SE-41]', async () => {
    const { world, east, west, session } = await setup();
    await world.master.pass(5);
    const [first] = takeRequests(east);
    const [other] = takeRequests(west);
    expect(first).toMatchObject({ pass: 1, sessionId: session.id, deltaTime: 0 });
    expect(other).toMatchObject({ pass: 1, records: [{ topic: '/in', double: 7 }] });
    // Everything waits for the last.
    await world.master.pass(50);
    answer(east, first!, 1);
    await world.master.pass(50);
    expect(world.ada.takeValues().filter(([topic]) => topic.startsWith('/out/'))).toEqual([]);
    answer(west, other!, 2);
    await world.master.pass();
    // In the order of the modules in the session.
    expect(world.ada.takeValues().filter(([topic]) => topic.startsWith('/out/'))).toEqual([
      ['/out/west', 2],
      ['/out/here', 7],
      ['/out/east', 1],
    ]);
  });

  it('gives all nodes the same delta time: that since the pass before [SE-40]', async () => {
    const { world, east, west } = await setup();
    await world.master.pass(5);
    answer(east, takeRequests(east)[0]!, 1);
    answer(west, takeRequests(west)[0]!, 1);
    await world.master.pass(PASS_MS);
    const deltas = [east, west].map((node) => takeRequests(node)[0]?.deltaTime);
    expect(deltas).toEqual([PASS_MS, PASS_MS]);
  });

  it('leaves out a node that does not answer, names it, and asks again when it does [SE-41]', async () => {
    const { world, east, west, session } = await setup();
    await world.master.pass(5);
    const late = takeRequests(west)[0]!;
    answer(east, takeRequests(east)[0]!, 1);
    await world.master.pass(600);
    const outputs = world.ada.takeValues().filter(([topic]) => topic.startsWith('/out/'));
    expect(outputs.map(([topic]) => topic)).toEqual(
      expect.arrayContaining(['/out/here', '/out/east']),
    );
    expect(outputs.map(([topic]) => topic)).not.toContain('/out/west');
    const now = await world.get(session);
    expect(now.extension?.problems).toContainEqual(
      expect.objectContaining({ code: 'node_late', nodeId: west.id }),
    );
    expect(takeRequests(west)).toEqual([]);
    // The others go on, without waiting for it.
    for (let i = 0; i < 3; i++) {
      for (const request of takeRequests(east)) answer(east, request, 1);
      await world.master.pass(PASS_MS);
    }
    expect(takeRequests(west)).toEqual([]);
    world.ada.takeSent();
    answer(west, late, 99);
    await world.master.pass();
    expect(world.ada.takeValues()).not.toContainEqual(['/out/west', 99]);
    for (const request of takeRequests(east)) answer(east, request, 1);
    await world.master.pass(PASS_MS);
    expect(takeRequests(west)).toHaveLength(1);
    expect(codes((await world.get(session)).extension?.problems)).not.toContain('node_late');
  });

  it('does not wait for a node that is gone [SE-31] [SE-41]', async () => {
    const { world, east, west, session } = await setup();
    await world.master.pass(5);
    answer(east, takeRequests(east)[0]!, 1);
    await world.master.call({
      topic: '/services/client/deregistration',
      client: { id: west.id },
    });
    await world.master.pass();
    const topics = world.ada.takeValues().map(([topic]) => topic);
    expect(topics).toEqual(expect.arrayContaining(['/out/here', '/out/east']));
    await world.master.pass(600);
    const { extension } = await world.get(session);
    expect(codes(extension?.problems)).toContain('node_gone');
    const late = extension?.problems.filter(({ code }) => code === 'node_late') ?? [];
    expect(late.map(({ nodeId }) => nodeId)).not.toContain(west.id);
  });

  it('reports its passes [SE-50]', async () => {
    const world = await SessionWorld.create();
    const { id } = await world.ask(TOPICS.start, lockstep([adder('here')]));
    await world.ada.subscribe({ subscribeTopics: [`/ubii/session/${id}/statistics`] });
    await world.master.pass(1000);
    expect(world.ada.takeRecords().at(-1)?.value).toMatchObject({
      passesPerSecond: expect.closeTo(10, -1),
    });
  });

  it('rests while the session is paused, and ends with it [SE-14]', async () => {
    const world = await SessionWorld.create();
    await world.ada.subscribe({ subscribeTopics: ['/out/here'] });
    const { id } = await world.ask(TOPICS.start, lockstep([adder('here')]));
    await world.master.pass(500);
    expect(world.ada.takeRecords().length).toBeGreaterThan(3);
    for (const [word, after] of [
      [TOPICS.pause, 0],
      [TOPICS.stop, 0],
    ] as const) {
      await world.ask(word, { id }).catch(() => undefined);
      world.ada.takeSent();
      await world.master.pass(500);
      const outputs = world.ada.takeRecords().filter(({ topic }) => topic === '/out/here');
      expect(outputs).toHaveLength(after);
    }
  });

  it('is not for nodes of the original, which are named [SE-42]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.original(world.master, 'nodejs');
    const session = await world.ask(TOPICS.start, lockstep([adder('far', node.id), adder('here')]));
    await node.ran(node.own(node.told('start')));
    const { extension } = await world.get(session);
    expect(extension?.state).toBe(SessionState.SESSION_RUNNING);
    expect(extension?.problems).toContainEqual(
      expect.objectContaining({ code: 'node_without_lockstep', nodeId: node.id }),
    );
    await world.master.pass(300);
    expect(takeRequests(node)).toEqual([]);
  });

  it('takes answers from nodes only [EX-20]', async () => {
    const { world, east, session } = await setup();
    await world.master.pass(5);
    const [request] = takeRequests(east);
    const frame = encodeLockstepReplyFrame({ pass: request!.pass, sessionId: session.id }, []);
    world.ada.socket.handleTopicData(frame);
    expect(world.ada.takeErrors()).toMatchObject([{ code: 'invalid_argument' }]);
  });
});
