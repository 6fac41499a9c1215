import {
  encode,
  ProcessingModuleLanguage,
  ProcessingModuleStatus,
  SessionState,
  SessionStatus,
  SERVICES,
} from '@ubii/proto';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import { describe, expect, it } from 'vitest';
import { codes, doubler, doubling, SessionWorld, TOPICS } from './session-world.ts';
import { OUR_NODE, TestNode } from './test-node.ts';

const { JS, PY } = ProcessingModuleLanguage;

/** A module as registered by a node of the original: a specification without code. */
const offered = {
  name: 'detector',
  inputs: [{ internalName: 'image', messageFormat: 'ubii.dataStructure.Image2D' }],
  outputs: [{ internalName: 'found', messageFormat: 'ubii.dataStructure.Object2DList' }],
  processingMode: { frequency: { hertz: 10 } },
};

describe('a session with a nodejs node', () => {
  it('gives it complete specifications, and runs when it says so [SE-1] [SE-11] [SE-12] [EC-10] [EC-11]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.original(world.master, 'nodejs', { processingModules: [offered] });
    const { processingModuleList } = await world.master.call({
      topic: SERVICES.processingModuleDatabaseGet.topic,
      processingModule: { name: offered.name },
    });
    expect(processingModuleList?.elements).toMatchObject([{ name: offered.name }]);
    const session = await world.ask(TOPICS.start, {
      name: 'detection',
      processingModules: [{ name: 'detector' }],
      ioMappings: [
        {
          processingModuleName: 'detector',
          inputMappings: [{ inputName: 'image', topicMux: { topicSelector: '/camera' } }],
        },
      ],
    });
    const told = node.told('start');
    expect(told.id).toBe(session.id);
    const [module] = node.own(told);
    expect(module).toMatchObject({ ...offered, nodeId: node.id, sessionId: session.id });
    expect(told.ioMappings).toHaveLength(1);
    expect(told.ioMappings[0]).toMatchObject({
      processingModuleId: module!.id,
      processingModuleName: 'detector',
    });
    expect(told.ioMappings[0]!.inputMappings[0]!.topicMux!.id).not.toBe('');
    expect((await world.get(session)).status).toBe(SessionStatus.CREATED);

    const reported = { ...module, status: ProcessingModuleStatus.PROCESSING, language: JS };
    expect((await node.ran([reported])).success).toBeDefined();
    expect((await world.get(session)).status).toBe(SessionStatus.RUNNING);

    await world.ask(TOPICS.stop, { id: session.id });
    expect(node.told('stop').id).toBe(session.id);
    expect((await world.get(session)).extension?.state).toBe(SessionState.SESSION_STOPPING);
    expect((await node.ended([module!])).success).toBeDefined();
    expect((await world.get(session)).status).toBe(SessionStatus.STOPPED);
  });

  it('is not told of a language, which ends its process, nor of sessions without mappings [SE-2] [EC-19] [EC-21]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.original(world.master, 'nodejs', { processingModules: [offered] });
    await world.ask(TOPICS.start, {
      processingModules: [
        { name: 'detector', language: PY },
        { ...doubler, language: 0 },
      ],
    });
    const told = node.told('start');
    expect(told.processingModules.map(({ language }) => language)).toEqual([0, JS]);
    // Zero is not written at all: not even as an explicit default.
    const [detector] = told.processingModules;
    const withoutLanguage = { ...detector!, language: undefined };
    expect(encode('ubii.processing.ProcessingModule', detector!)).toEqual(
      encode('ubii.processing.ProcessingModule', withoutLanguage),
    );
    expect(told.ioMappings).toHaveLength(2);
  });

  it('may report with an empty list, for sessions that are none of its own [SE-32]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.original(world.master, 'nodejs');
    await world.ask(TOPICS.start, doubling('/in', '/out'));
    expect((await node.ran([])).success).toBeDefined();
    expect((await node.ended([])).success).toBeDefined();
  });

  it('is answered with the unknown modules, and the rest counts [SE-32]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.original(world.master, 'nodejs', { processingModules: [offered] });
    const other = await TestNode.original(world.master, 'other');
    const session = await world.ask(TOPICS.start, { processingModules: [{ name: 'detector' }] });
    const [module] = node.own(node.told('start'));
    // A node cannot report for modules of other nodes.
    const foreign = await other.ran([{ ...module, nodeId: other.id }]);
    expect(foreign.error).toMatchObject({ code: 'not_found' });
    expect((await world.get(session)).status).toBe(SessionStatus.CREATED);
    const { error } = await node.ran([{ id: 'unknown', nodeId: node.id }, module!]);
    expect(error).toMatchObject({ code: 'not_found', message: expect.stringContaining('unknown') });
    expect((await world.get(session)).status).toBe(SessionStatus.RUNNING);
  });
});

describe('a session with a Python node', () => {
  it('is started by it, with all defaults, and mapped by name [SE-6] [SE-11] [EC-5]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.original(world.master, 'python', {
      isDedicatedProcessingNode: false,
      processingModules: [{ ...offered, language: PY }],
    });
    const { session, error } = await world.master.callJson({
      topic: TOPICS.start,
      session: {
        id: '',
        name: 'py',
        processingModules: [
          { id: '', name: 'detector', nodeId: '', sessionId: '', language: 0, status: 0, tags: [] },
        ],
        ioMappings: [
          {
            processingModuleId: '',
            processingModuleName: 'detector',
            inputMappings: [{ inputName: 'image', topic: '/camera' }],
            outputMappings: [{ outputName: 'found', topic: '/found' }],
          },
        ],
        tags: [],
        status: 0,
        editable: false,
      },
    });
    expect(error).toBeUndefined();
    const told = node.told('start');
    expect(told.id).toBe(session!.id);
    const [module] = node.own(told);
    // Chosen by name although it is not dedicated [SE-30].
    expect(module).toMatchObject({ ...offered, language: PY });
    await node.ran([{ ...module, status: ProcessingModuleStatus.CREATED }]);
    expect((await world.get(session!)).status).toBe(SessionStatus.RUNNING);
  });
});

describe('a session with a Unity node', () => {
  it('does not wait forever for the end of its modules [SE-13]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.original(world.master, 'unity', { processingModules: [offered] });
    const session = await world.ask(TOPICS.start, { processingModules: [{ name: 'detector' }] });
    await node.ran(node.own(node.told('start')));
    await world.ask(TOPICS.stop, { id: session.id });
    await node.pass(10_500);
    const { status, extension } = await world.get(session);
    expect(status).toBe(SessionStatus.STOPPED);
    expect(extension?.problems[0]).toMatchObject({
      code: 'module_not_stopped',
      nodeId: node.id,
      message: expect.stringContaining('unity'),
    });
  });
});

describe('a module that is not reported', () => {
  it('makes the session degraded, and a late report repairs it [SE-12]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.original(world.master, 'nodejs', { processingModules: [offered] });
    const session = await world.ask(TOPICS.start, {
      processingModules: [{ name: 'detector' }, doubler],
    });
    await node.pass(10_500);
    const degraded = await world.get(session);
    expect(degraded.extension?.state).toBe(SessionState.SESSION_DEGRADED);
    expect(degraded.extension?.problems[0]).toMatchObject({
      code: 'module_not_started',
      moduleName: 'detector',
      nodeId: node.id,
    });
    await node.ran(node.own(node.told('start')));
    const { extension } = await world.get(session);
    expect(extension?.state).toBe(SessionState.SESSION_RUNNING);
    expect(codes(extension?.problems)).not.toContain('module_not_started');
  });

  it('is not late while its node reports that it loads an asset set [SE-12] [PM-94]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.ours(world.master, 'lab', { processingModules: [offered] });
    const session = await world.ask(TOPICS.start, { processingModules: [{ name: 'detector' }] });
    const [module] = node.own(node.told('start'));
    for (let loadedBytes = 0; loadedBytes < 3; loadedBytes++) {
      const loading = { loadingSet: 'model', loadedBytes, loadingBytes: 3 };
      const statistics = [{ moduleId: module!.id, ...loading }];
      node.client.socket.handleTopicData(encodeNodeMessageFrame({ moduleReports: { statistics } }));
      await node.pass(9000);
    }
    expect((await world.get(session)).extension?.state).toBe(SessionState.SESSION_STARTING);
    await node.ran([module!]);
    expect((await world.get(session)).extension?.state).toBe(SessionState.SESSION_RUNNING);
  });

  it('alone stops the session again [SE-12]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.original(world.master, 'nodejs', { processingModules: [offered] });
    const session = await world.ask(TOPICS.start, { processingModules: [{ name: 'detector' }] });
    await node.pass(21_000);
    expect((await world.get(session)).status).toBe(SessionStatus.STOPPED);
  });
});

describe('a node that goes', () => {
  it('loses the modules the master gave it to another node [SE-31]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.ours(world.master, 'node', {
      isDedicatedProcessingNode: true,
      processingModules: [doubler],
    });
    const session = await world.ask(TOPICS.start, doubling('/in', '/out'));
    await node.ran(node.own(node.told('start')));
    expect((await world.get(session)).status).toBe(SessionStatus.RUNNING);
    await world.master.call({
      topic: '/services/client/deregistration',
      client: { id: node.id },
    });
    await world.master.pass();
    const { processingModules, extension } = await world.get(session);
    expect(extension?.state).toBe(SessionState.SESSION_RUNNING);
    expect(processingModules[0]?.nodeId).not.toBe(node.id);
    world.ada.publish('/in', 'double', 3);
    await world.master.pass(10);
    expect(await world.value('/out')).toBe(6);
  });

  it('is waited for by modules that the session assigns to it [SE-31]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.ours(world.master, 'tab');
    const session = await world.ask(TOPICS.start, {
      ...doubling('/in', '/out'),
      processingModules: [{ ...doubler, nodeId: node.id }],
    });
    await node.ran(node.own(node.told('start')));
    node.client.drop();
    await world.master.pass(11_000);
    const degraded = await world.get(session);
    expect(degraded.extension?.state).toBe(SessionState.SESSION_DEGRADED);
    expect(degraded.extension?.problems[0]).toMatchObject({ code: 'node_gone', nodeId: node.id });
    expect(degraded.processingModules[0]?.nodeId).toBe(node.id);
    // While it is waited for, it can be stopped and started.
    const stopped = await world.ask(TOPICS.stop, { id: session.id }).then(() => world.get(session));
    expect(codes(stopped.extension?.problems)).not.toContain('node_gone');
    await world.ask(TOPICS.start, { id: session.id });

    node.takeNews();
    node.client.open();
    await world.master.pass();
    const [module] = node.own(node.told('change'));
    expect(module?.status).toBe(ProcessingModuleStatus.INITIALIZED);
    await node.ran([module!]);
    expect((await world.get(session)).extension).toMatchObject({
      state: SessionState.SESSION_RUNNING,
    });
  });

  it('is missed by a session that waits to be started, until it is back [SE-5]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.ours(world.master, 'tab');
    node.client.drop();
    await world.master.pass(11_000);
    const session = await world.ask(TOPICS.add, {
      ...doubling('/in', '/out'),
      processingModules: [{ ...doubler, nodeId: node.id }],
    });
    expect(codes(session.extension?.problems)).toContain('node_unavailable');
    node.client.open();
    const { extension } = await world.get(session);
    expect(codes(extension?.problems)).not.toContain('node_unavailable');
  });

  it('is not waited for while the session stops [SE-31]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.ours(world.master, 'tab');
    const session = await world.ask(TOPICS.start, {
      processingModules: [{ ...doubler, nodeId: node.id }],
    });
    await node.ran(node.own(node.told('start')));
    await world.ask(TOPICS.stop, { id: session.id });
    await world.master.call({
      topic: '/services/client/deregistration',
      client: { id: node.id },
    });
    expect((await world.get(session)).status).toBe(SessionStatus.STOPPED);
  });

  it('is told to stop what was stopped meanwhile [SE-33]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.ours(world.master, 'tab');
    const session = await world.ask(TOPICS.start, {
      processingModules: [{ ...doubler, nodeId: node.id }],
    });
    const modules = node.own(node.told('start'));
    await world.ask(TOPICS.stop, { id: session.id });
    await node.ended(modules);
    node.takeNews();
    expect((await node.ran(modules)).success).toBeDefined();
    expect(node.told('stop').id).toBe(session.id);
    expect(world.takeWords().filter((word) => word === 'stop')).toHaveLength(1);
  });
});

describe('the master', () => {
  it('lists itself and all nodes, with what they run [PM-60] [PM-61]', async () => {
    const world = await SessionWorld.create();
    const ours = await TestNode.ours(world.master, 'a tab');
    const original = await TestNode.original(world.master, 'b nodejs', {
      processingModules: [offered],
    });
    await world.ask(TOPICS.start, doubling('/in', '/out'));
    const { nodeList } = await world.master.call({ topic: TOPICS.nodes });
    expect(nodeList!.elements).toMatchObject([
      { instances: 1, available: true, dedicated: true },
      { clientId: ours.id, node: OUR_NODE, instances: 0, available: true, dedicated: false },
      { clientId: original.id, moduleNames: ['detector'], dedicated: true },
    ]);
  });

  it('chooses the node with the least work for its capacity [SE-30]', async () => {
    const world = await SessionWorld.create();
    const needy = { ...doubler, extension: { libraries: ['vision'] } };
    const withVision = (capacity: number) => ({
      extension: { node: { ...OUR_NODE, libraries: ['vision'], capacity } },
    });
    const small = await TestNode.ours(world.master, 'small', withVision(1));
    const large = await TestNode.ours(world.master, 'large', withVision(3));
    const used: string[] = [];
    for (let i = 0; i < 4; i++) {
      const { processingModules } = await world.ask(TOPICS.start, { processingModules: [needy] });
      used.push(processingModules[0]!.nodeId);
    }
    expect(used.filter((id) => id === small.id)).toHaveLength(1);
    expect(used.filter((id) => id === large.id)).toHaveLength(3);
  });

  it('says when no node can run a module, and why [SE-4]', async () => {
    const world = await SessionWorld.create();
    const tab = await TestNode.ours(world.master, 'tab');
    const needy = { ...doubler, extension: { libraries: ['vision'] } };
    const chosen = await world.refusal(TOPICS.add, { processingModules: [needy] });
    expect(codes(chosen.problems)).toContain('node_cannot_run');
    const named = await world.refusal(TOPICS.add, {
      processingModules: [{ ...needy, nodeId: tab.id }],
    });
    expect(named.problems[0]).toMatchObject({ code: 'node_cannot_run', nodeId: tab.id });
    expect(named.message).toContain('vision');
  });
});
