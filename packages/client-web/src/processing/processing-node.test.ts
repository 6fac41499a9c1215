import {
  ModuleEventKind,
  NodeExtensionKind,
  ProcessingModuleLanguage,
  ProcessingModuleStatus,
  ServiceError,
  SessionState,
} from '@ubii/proto';
import type { TopicRecord } from '@ubii/proto';
import { encodeRecord } from '@ubii/proto';
import { encodeLockstepRequestFrame } from '@ubii/proto/wire';
import { describe, expect, it } from 'vitest';
import { FakeMaster } from '../testing/fake-master.ts';
import { createNodeWorld, rest, sessionOf, timesTen } from '../testing/node-world.ts';

type World = Awaited<ReturnType<typeof createNodeWorld>>;

const put = async ({ master }: World, topic: string, value: number): Promise<void> => {
  master.publish({ topic, format: 'double', value });
  await rest();
};

const outputs = ({ master }: World): [string, unknown][] =>
  master.published.map(({ topic, value }: TopicRecord) => [topic, value]);

const eventsOf = ({ master }: World) =>
  master.nodeMessages.flatMap(({ moduleReports }) => moduleReports?.events ?? []);

async function setupRunning(mode?: ReturnType<typeof timesTen>['processingMode']) {
  const world = await createNodeWorld();
  const module = { ...timesTen(world.client.id), ...(mode ? { processingMode: mode } : {}) };
  world.sessions.start(sessionOf(module));
  await rest();
  return { ...world, module };
}

describe('a node says what it is', () => {
  it('[PM-60] with kind, capacity, libraries, and its modules without their code', async () => {
    const own = timesTen('', '');
    const { master } = await createNodeWorld({
      kind: 'browser',
      capacity: 4,
      libraries: ['http'],
      modules: [own],
      isDedicated: true,
    });
    const registered = master.requests.filter(({ client }) => client !== undefined).at(-1)?.client;
    expect(registered).toMatchObject({
      isDedicatedProcessingNode: true,
      extension: {
        node: {
          kind: NodeExtensionKind.BROWSER,
          runsJavascript: true,
          acceptsWork: true,
          libraries: ['http'],
          capacity: 4,
        },
      },
    });
    expect(registered?.processingModules).toMatchObject([
      { name: 'times-ten', inputs: own.inputs, onProcessingStringified: '' },
    ]);
  });

  it('again when its modules change, or whether it takes work', async () => {
    const { node, master } = await createNodeWorld();
    await node.setModules([timesTen('', '')]);
    await node.setAcceptsWork(false);
    expect(master.requests.at(-1)?.client).toMatchObject({
      processingModules: [{ name: 'times-ten' }],
      extension: { node: { acceptsWork: false } },
    });
  });
});

describe('a node and the sessions', () => {
  it('[PM-62] runs what is assigned to it, reports it, and ends it on stop', async () => {
    const world = await setupRunning();
    const { sessions, node, client } = world;
    expect(sessions.reports).toMatchObject([
      {
        kind: 'add',
        modules: [
          {
            id: 'm1',
            name: 'times-ten',
            nodeId: client.id,
            sessionId: 's1',
            status: ProcessingModuleStatus.PROCESSING,
          },
        ],
      },
    ]);
    await put(world, '/m1/in', 4);
    expect(outputs(world)).toEqual([['/m1/out', 40]]);
    expect(node.instances).toMatchObject([
      { id: 'm1', moduleName: 'times-ten', sessionName: 'lesson', sessionId: 's1' },
    ]);
    sessions.stop('s1');
    await rest();
    expect(sessions.told).toEqual(['add m1', 'remove m1']);
    expect(node.instances).toEqual([]);
    await put(world, '/m1/in', 5);
    expect(outputs(world)).toHaveLength(1);
    expect(world.master.holds(client.id).topics).not.toContain('/m1/in');
  });

  it('leaves the modules of other nodes alone', async () => {
    const world = await createNodeWorld();
    world.sessions.start(sessionOf(timesTen('another-client')));
    await rest();
    expect(world.node.instances).toEqual([]);
    expect(world.sessions.reports).toEqual([]);
  });

  it('reports all modules of a session in one request', async () => {
    const world = await createNodeWorld();
    const { id } = world.client;
    world.sessions.start(sessionOf(timesTen(id, 'm1'), timesTen(id, 'm2'), timesTen(id, 'm3')));
    await rest();
    expect(world.sessions.reports).toHaveLength(1);
    expect(world.sessions.told).toEqual(['add m1', 'add m2', 'add m3']);
  });

  it('takes up what runs already when it connects', async () => {
    const world = await createNodeWorld();
    const { client, sessions, node } = world;
    await node.stop();
    sessions.put(sessionOf(timesTen(client.id)), SessionState.SESSION_RUNNING);
    await node.start();
    await rest();
    expect(sessions.told).toEqual(['add m1']);
    await put(world, '/m1/in', 1);
    expect(outputs(world)).toEqual([['/m1/out', 10]]);
  });

  it('does not believe an announcement that is older than the list', async () => {
    const world = await createNodeWorld();
    const { client, sessions, node } = world;
    await node.stop();
    sessions.start(sessionOf(timesTen(client.id))); // retained, and sent again on subscribing
    sessions.put(sessionOf(timesTen(client.id)), SessionState.SESSION_STOPPED);
    await node.start();
    await rest();
    expect(node.instances).toEqual([]);
    expect(sessions.reports).toEqual([]);
  });

  it('[PM-62] applies other mappings and another mode without a restart', async () => {
    const world = await setupRunning();
    const { module, sessions } = world;
    await put(world, '/m1/in', 1);
    const changed = sessionOf(module);
    sessions.change({
      ...changed,
      ioMappings: [
        {
          processingModuleId: 'm1',
          inputMappings: [{ inputName: 'in', topic: '/other' }],
          outputMappings: [{ outputName: 'out', topic: '/elsewhere' }],
        },
      ],
    });
    await rest();
    await put(world, '/other', 2);
    await put(world, '/m1/in', 3);
    expect(outputs(world)).toEqual([
      ['/m1/out', 10],
      ['/elsewhere', 20],
    ]);
    expect(sessions.told).toEqual(['add m1']);
  });

  it('[PM-62] restarts what has other code, and ends what has left the session', async () => {
    const world = await setupRunning();
    const { module, sessions, client } = world;
    const other = {
      ...module,
      onProcessingStringified: '() => ({ outputs: { out: { double: -1 } } })',
    };
    sessions.change(sessionOf(other, timesTen(client.id, 'm2')));
    await rest();
    await put(world, '/m1/in', 1);
    expect(outputs(world)).toEqual([['/m1/out', -1]]);
    sessions.change(sessionOf(timesTen(client.id, 'm2')));
    await rest();
    expect(sessions.told.filter((each) => each.endsWith('m1'))).toEqual([
      'add m1',
      'remove m1',
      'add m1',
      'remove m1',
    ]);
    expect(world.node.instances.map(({ id }) => id)).toEqual(['m2']);
  });

  it('[SE-14] holds its modules with their state, and lets them go on', async () => {
    const world = await createNodeWorld();
    const { client, sessions } = world;
    const counting = {
      ...timesTen(client.id),
      onProcessingStringified:
        '(dt, inputs, state) => { state.n = (state.n ?? 0) + 1; return { outputs: { out: { double: state.n } } } }',
    };
    sessions.start(sessionOf(counting));
    await rest();
    await put(world, '/m1/in', 0);
    sessions.change(sessionOf(counting), SessionState.SESSION_PAUSED);
    await rest();
    await put(world, '/m1/in', 0);
    expect(outputs(world)).toHaveLength(1);
    expect(world.node.instances[0]?.status).toBe(ProcessingModuleStatus.HALTED);
    sessions.change(sessionOf(counting), SessionState.SESSION_RUNNING);
    await rest();
    await put(world, '/m1/in', 0);
    expect(outputs(world).at(-1)).toEqual(['/m1/out', expect.any(Number)]);
    expect(Number(outputs(world).at(-1)?.[1])).toBeGreaterThan(1);
    expect(sessions.told).toEqual(['add m1']);
  });

  it('makes modules again when their session is stopped and started in one turn', async () => {
    const world = await setupRunning();
    world.sessions.stop('s1');
    world.sessions.start(sessionOf(world.module));
    await rest();
    expect(world.sessions.told).toEqual(['add m1', 'remove m1', 'add m1']);
  });

  it('[SE-13] reports the end of modules that were stopped before they could be made', async () => {
    const world = await createNodeWorld();
    world.sessions.start(sessionOf(timesTen(world.client.id)));
    world.sessions.stop('s1');
    await rest();
    expect(world.sessions.told).toEqual(['remove m1']);
    expect(world.node.instances).toEqual([]);
  });

  it('[SE-15] tries what failed again with the next revision of its session', async () => {
    const world = await createNodeWorld();
    const bad = { ...timesTen(world.client.id), onCreatedStringified: '() => { throw 1; }' };
    const at = (revision: number) => ({ ...sessionOf(bad), extension: { revision } });
    const failures = () => eventsOf(world).filter(({ kind }) => kind === ModuleEventKind.FAILED);
    world.sessions.start(at(1));
    await rest();
    world.sessions.change(at(1), SessionState.SESSION_PAUSED);
    await rest();
    expect(failures()).toHaveLength(1);
    world.sessions.change(at(2));
    await rest();
    expect(failures()).toHaveLength(2);
  });

  it('[SE-33] ends what the master knows nothing of', async () => {
    const world = await setupRunning();
    const { sessions, node, module } = world;
    sessions.forget('s1');
    world.master.publish({
      topic: '/info/session/start',
      format: 'session',
      value: sessionOf(module),
    });
    await rest();
    expect(node.instances).toEqual([]);
  });

  it('stops: ends everything, reports it, and is no node any more', async () => {
    const world = await setupRunning();
    await world.node.stop();
    expect(world.sessions.told).toEqual(['add m1', 'remove m1']);
    const registered = world.master.requests.at(-1)?.client;
    expect(registered?.extension?.node).toBeUndefined();
    expect(registered?.processingModules).toEqual([]);
    world.sessions.start(sessionOf(world.module));
    await rest();
    expect(world.sessions.told).toHaveLength(2);
    expect(world.node.instances).toEqual([]);
    expect(world.clock.timerCount).toBeLessThanOrEqual(2); // the client's own: PING and the watch for sleep
  });
});

describe('starting and stopping', () => {
  it('happens in the order of the calls, each once', async () => {
    const world = await setupRunning();
    const { node, master } = world;
    await Promise.all([node.stop(), node.start(), node.start()]);
    await rest();
    expect(node.isStarted).toBe(true);
    expect(master.requests.findLast(({ client }) => client)?.client?.extension?.node).toBeDefined();
    expect(world.sessions.told).toEqual(['add m1', 'remove m1', 'add m1']);
  });

  it('leaves a node that the master refuses as it was', async () => {
    const { node, master } = await createNodeWorld();
    await node.stop();
    master.onRequest = ({ client }) =>
      client === undefined ? undefined : new ServiceError('resource_exhausted', 'no room');
    await expect(node.start()).rejects.toThrow('no room');
    expect(node.isStarted).toBe(false);
    master.onRequest = undefined;
    await node.start();
    expect(node.isStarted).toBe(true);
  });
});

describe('code', () => {
  it('[PM-64] of the node is taken where the session brings none', async () => {
    const world = await createNodeWorld({ modules: [timesTen('', '')] });
    const { onProcessingStringified: _, inputs: _in, ...bare } = timesTen(world.client.id);
    world.sessions.start(sessionOf(bare));
    await rest();
    await put(world, '/m1/in', 2);
    expect(outputs(world)).toEqual([['/m1/out', 20]]);
  });

  it('[PM-64] of the session wins over that of the node', async () => {
    const world = await createNodeWorld({ modules: [timesTen('', '')] });
    const other = {
      ...timesTen(world.client.id),
      onProcessingStringified: '() => ({ outputs: { out: { double: 7 } } })',
    };
    world.sessions.start(sessionOf(other));
    await rest();
    await put(world, '/m1/in', 2);
    expect(outputs(world).at(-1)).toEqual(['/m1/out', 7]);
  });

  it.each([
    ['without code', { onProcessingStringified: '' }, /has code of the module "times-ten"/],
    ['in another language', { language: ProcessingModuleLanguage.PY }, /written in PY/],
    ['that does not parse', { onProcessingStringified: '(=> 3' }, /./],
    ['that fails in onCreated', { onCreatedStringified: '() => { throw new Error("no") }' }, /no/],
  ])('%s is reported as failed, and what follows it works', async (_title, fault, message) => {
    const world = await createNodeWorld();
    const { client, sessions, node } = world;
    sessions.start(sessionOf({ ...timesTen(client.id), ...fault }, timesTen(client.id, 'm2')));
    await rest();
    const failed = eventsOf(world).filter(({ kind }) => kind === ModuleEventKind.FAILED);
    expect(failed).toMatchObject([
      { sessionId: 's1', moduleId: 'm1', moduleName: 'times-ten', nodeId: client.id },
    ]);
    expect(failed[0]?.message).toMatch(message);
    expect(sessions.told).toEqual(['add m2']);
    expect(node.instances.find(({ id }) => id === 'm1')?.fault).toBeDefined();
    // A change elsewhere in the session does not try it again.
    sessions.change(sessionOf({ ...timesTen(client.id), ...fault }, timesTen(client.id, 'm2')));
    await rest();
    expect(eventsOf(world).filter(({ kind }) => kind === ModuleEventKind.FAILED)).toHaveLength(1);
    sessions.stop('s1');
    await rest();
    expect(node.instances).toEqual([]);
    expect([...sessions.told].sort()).toEqual(['add m2', 'remove m1', 'remove m2']);
  });
});

describe('reports', () => {
  it('[PM-80] are statistics in intervals, while something runs', async () => {
    const world = await setupRunning();
    await put(world, '/m1/in', 1);
    await world.clock.advance(250);
    const statistics = world.master.nodeMessages.flatMap(
      ({ moduleReports }) => moduleReports?.statistics ?? [],
    );
    expect(statistics.at(-1)).toMatchObject({ moduleId: 'm1', nodeId: world.client.id });
    expect(statistics.at(-1)?.runs).toBeGreaterThanOrEqual(1);
    expect(world.node.instances[0]?.statistics?.runs).toBe(statistics.at(-1)?.runs);
    world.sessions.stop('s1');
    await rest();
    const count = world.master.nodeMessages.length;
    await world.clock.advance(1_000);
    expect(world.master.nodeMessages).toHaveLength(count);
  });

  it('[PM-81] are events at once', async () => {
    const world = await createNodeWorld();
    const heard: string[] = [];
    world.node.onEvent(({ message }) => heard.push(message));
    world.sessions.start(
      sessionOf({
        ...timesTen(world.client.id),
        onProcessingStringified: '() => { console.log("hello"); }',
      }),
    );
    await rest();
    await put(world, '/m1/in', 1);
    expect(eventsOf(world)).toMatchObject([{ message: 'hello', moduleId: 'm1' }]);
    expect(heard).toEqual(['hello']);
  });
});

describe('lockstep', () => {
  const lockstep = { lockstep: {} };

  it('[PM-27] [SE-40] runs its share and answers with the outputs, not published', async () => {
    const world = await setupRunning(lockstep);
    const frame = encodeLockstepRequestFrame(
      { processingModuleIds: ['m1', 'gone'], pass: 9, sessionId: 's1', deltaTime: 16.5 },
      [encodeRecord({ topic: '/m1/in', format: 'double', value: 3 })],
    );
    world.master.sendBytes(frame);
    await rest();
    expect(world.master.published).toEqual([]);
    const reply = world.master.nodeMessages.at(-1)?.lockstepReply;
    expect(reply).toMatchObject({ pass: 9, sessionId: 's1', processingModuleIds: ['m1'] });
    expect(reply?.records).toMatchObject([{ topic: '/m1/out', double: 30 }]);
  });

  it('[SE-41] answers although it has nothing of what it is asked for', async () => {
    const world = await createNodeWorld();
    world.master.sendBytes(
      encodeLockstepRequestFrame({ processingModuleIds: ['x'], pass: 1, sessionId: 's' }, []),
    );
    await rest();
    expect(world.master.nodeMessages).toMatchObject([
      { lockstepReply: { pass: 1, sessionId: 's', processingModuleIds: [], records: [] } },
    ]);
  });
});

describe('connections that drop', () => {
  it('[PM-63] leave the instances as they are, and they are reported again', async () => {
    const world = await setupRunning();
    const { master, clock, sessions, client, node } = world;
    const { id } = client;
    master.stop();
    await rest();
    expect(node.instances).toHaveLength(1);
    master.isDown = false;
    await clock.advance(10_000);
    await rest();
    expect(client.id).toBe(id);
    expect(sessions.told).toEqual(['add m1', 'add m1']);
    await put(world, '/m1/in', 4);
    expect(outputs(world).at(-1)).toEqual(['/m1/out', 40]);
  });

  it('take with them what the master gave to others meanwhile', async () => {
    const world = await setupRunning();
    const { master, clock, sessions, node, module } = world;
    master.stop();
    sessions.put(sessionOf({ ...module, nodeId: 'other' }), SessionState.SESSION_RUNNING);
    master.isDown = false;
    await clock.advance(10_000);
    await rest();
    expect(node.instances).toEqual([]);
    expect(sessions.told).toEqual(['add m1', 'remove m1']);
  });

  it('with a master that forgot its sessions end everything', async () => {
    const world = await setupRunning();
    const { master, clock, sessions, node } = world;
    master.restart();
    sessions.forget('s1');
    await clock.advance(10_000);
    await rest();
    expect(node.instances).toEqual([]);
  });

  it('keep what could not be reported', async () => {
    const world = await setupRunning();
    const { master, clock, sessions, module } = world;
    sessions.stop('s1');
    master.isDown = true;
    await rest();
    master.drop();
    master.isDown = false;
    await clock.advance(20_000);
    await rest();
    expect(sessions.told.at(-1)).toBe(`remove ${module.id}`);
  });

  it('give all up that ran under another id', async () => {
    const world = await setupRunning();
    const { master, clock, sessions, node, client } = world;
    const { id } = client;
    master.restart({ hasNewKey: true });
    await clock.advance(20_000);
    await rest();
    expect(client.id).not.toBe(id);
    expect(node.instances).toEqual([]);
    const again = timesTen(client.id);
    sessions.start(sessionOf(again));
    await rest();
    await put(world, '/m1/in', 4);
    expect(outputs(world).at(-1)).toEqual(['/m1/out', 40]);
    const last = world.master.published.at(-1)!;
    expect(last.clientId).toBe(client.id);
  });
});

it('tells of changes, at most once a turn', async () => {
  const world = await createNodeWorld();
  const seen: number[] = [];
  world.node.onChange((instances) => seen.push(instances.length));
  const { id } = world.client;
  world.sessions.start(sessionOf(timesTen(id, 'm1'), timesTen(id, 'm2')));
  await rest();
  expect(seen.at(-1)).toBe(2);
  expect(seen.length).toBeLessThan(12);
});

describe('what modules publish', () => {
  it('[TS-9] is stamped in the time of the master', async () => {
    const masterMs = 1_800_000_000_000;
    const world = await createNodeWorld({}, new FakeMaster({ timeMs: () => masterMs }));
    world.sessions.start(sessionOf(timesTen(world.client.id)));
    await rest();
    await put(world, '/m1/in', 2);
    expect(world.master.published).toMatchObject([{ value: 20, timestampMs: masterMs }]);
  });
});
