import { createProcessingNode } from '@ubii/client-web/processing';
import type { ProcessingNode } from '@ubii/client-web/processing';
import type { UbiiClient } from '@ubii/client-web/node';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import {
  ModuleEventKind,
  SessionState,
  type Init,
  type ProcessingMode,
  type ProcessingModule,
  type Session,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { ClientWorld } from '../client-world.ts';

/** A master, a client that publishes and watches, and nodes of ours. */
class NodeWorld {
  readonly world = new ClientWorld();
  ada!: UbiiClient;
  /** Records of the topics below /out/, in order. */
  readonly outputs: [topic: string, value: unknown][] = [];

  static async create(): Promise<NodeWorld> {
    const created = new NodeWorld();
    created.ada = (await created.world.connect('ada')).client;
    created.ada
      .subscribe({ glob: '/out/**' })
      .onRecord(({ topic, value }) => created.outputs.push([topic, value]));
    await created.pass();
    return created;
  }

  async joinAsNode(
    name: string,
    libraries: Readonly<Record<string, unknown>> = {},
  ): Promise<{ client: UbiiClient; node: ProcessingNode }> {
    const { client } = await this.world.connect(name);
    const node = createProcessingNode(client, {
      kind: 'node',
      sandboxes: createInlineSandboxes({ libraries }),
      libraries: Object.keys(libraries),
      clock: this.world.clock,
    });
    const started = node.start();
    await this.pass();
    await started;
    await this.pass();
    return { client, node };
  }

  /** Lets time pass, and what it leads to: a message of a node takes some turns. */
  async pass(durationMs = 0): Promise<void> {
    await this.world.pass(durationMs);
    for (let i = 0; i < 8; i++) await this.world.pass(0);
  }

  async put(topic: string, value: number): Promise<void> {
    this.ada.publish(topic, 'double', value);
    await this.pass();
  }

  async start(session: Init<Session>): Promise<Session> {
    const started = this.ada.call('sessionRuntimeStart', session);
    await this.pass();
    const { id } = await started;
    await this.pass();
    return this.get(id);
  }

  async get(id: string): Promise<Session> {
    const got = this.ada.call('sessionRuntimeGet', { id });
    await this.pass();
    return got;
  }

  async update(session: Init<Session>): Promise<Session> {
    const updated = this.ada.call('sessionRuntimeUpdate', session);
    await this.pass();
    await updated;
    await this.pass();
    return this.get(session.id!);
  }

  async call(service: 'sessionRuntimeStop' | 'sessionRuntimeRemove', { id }: { id: string }) {
    const called = this.ada.call(service, { id });
    await this.pass();
    await called;
    await this.pass();
  }

  /** Topics with a value, but for those of the master. */
  async topics(): Promise<string[]> {
    const got = this.ada.call('topicList');
    await this.pass();
    const { elements } = await got;
    return elements.filter((topic) => !/^\/(info|services)\//.test(topic)).sort();
  }

  async stateOf({ id }: Session): Promise<SessionState | undefined> {
    return (await this.get(id)).extension?.state;
  }
}

/** Puts out what comes in and how often it ran. */
function counter(nodeId: string, name: string, mode: Init<ProcessingMode>): Init<ProcessingModule> {
  return {
    name,
    nodeId,
    processingMode: mode,
    inputs: [{ internalName: 'in', messageFormat: 'double' }],
    outputs: [{ internalName: 'out', messageFormat: 'vector2' }],
    onProcessingStringified: `(deltaTime, inputs, state) => {
      state.runs = (state.runs ?? 0) + 1;
      return { outputs: { out: { vector2: { x: inputs.in ? inputs.in.double : -1, y: state.runs } } } };
    }`,
  };
}

function sessionOf(...modules: Init<ProcessingModule>[]): Init<Session> {
  return {
    name: 'lesson',
    processingModules: modules,
    ioMappings: modules.map(({ name = '' }) => ({
      processingModuleName: name,
      inputMappings: [{ inputName: 'in', topic: '/in' }],
      outputMappings: [{ outputName: 'out', topic: `/out/${name}` }],
    })),
  };
}

/** The session with all inputs mapped to another topic. */
function withInput(session: Session, topic: string): Init<Session> {
  const inputMappings = [{ inputName: 'in', topic }];
  return {
    ...session,
    ioMappings: session.ioMappings.map((mapping) => ({ ...mapping, inputMappings })),
  };
}

const TRIGGER = { triggerOnInput: {} };

describe('a node of ours', () => {
  it.each<[string, Init<ProcessingMode>]>([
    ['with a frequency [PM-21]', { frequency: { hertz: 50 } }],
    ['when an input changes [PM-23]', TRIGGER],
    ['in lockstep [PM-27]', { lockstep: {} }],
    ['as fast as it may [PM-28]', { free: {} }],
  ])('runs a module of a session %s', async (_title, mode) => {
    const room = await NodeWorld.create();
    const { client, node } = await room.joinAsNode('node');
    const session = await room.start(sessionOf(counter(client.id, 'm', mode)));
    expect(session.extension?.state).toBe(SessionState.SESSION_RUNNING);
    expect(node.instances).toMatchObject([{ moduleName: 'm', sessionName: 'lesson' }]);
    await room.put('/in', 7);
    await room.pass(500);
    expect(room.outputs.at(-1)).toMatchObject(['/out/m', { x: 7 }]);
    const stopped = room.ada.call('sessionRuntimeStop', { id: session.id });
    await room.pass();
    await stopped;
    await room.pass(100);
    expect(await room.stateOf(session)).toBe(SessionState.SESSION_STOPPED);
    const count = room.outputs.length;
    await room.put('/in', 8);
    await room.pass(500);
    expect(room.outputs).toHaveLength(count);
    expect(node.instances).toEqual([]);
  });

  it('takes part in lockstep passes with another one, on one snapshot [SE-40] [SE-41]', async () => {
    const room = await NodeWorld.create();
    const { client: one } = await room.joinAsNode('one');
    const { client: two } = await room.joinAsNode('two');
    await room.put('/in', 1);
    const lockstep = { lockstep: {} };
    const session = await room.start(
      sessionOf(counter(one.id, 'a', lockstep), counter(two.id, 'b', lockstep)),
    );
    expect(await room.stateOf(session)).toBe(SessionState.SESSION_RUNNING);
    for (let value = 2; value < 6; value++) {
      await room.put('/in', value);
      await room.pass(100);
    }
    const passes = room.outputs.map(([topic, value]) => [topic, (value as { x: number }).x]);
    expect(passes.length).toBeGreaterThan(8);
    expect(passes.length % 2).toBe(0);
    // In the order of the modules, and of one pass both saw the same.
    for (let i = 0; i < passes.length; i += 2) {
      expect(passes[i]?.[0]).toBe('/out/a');
      expect(passes[i + 1]).toEqual(['/out/b', passes[i]?.[1]]);
    }
    expect(passes.at(-1)?.[1]).toBe(5);
  });

  it('that dies is missed, and goes on when it returns [SE-31] [PM-63]', async () => {
    const room = await NodeWorld.create();
    const { client, node } = await room.joinAsNode('node');
    const session = await room.start(sessionOf(counter(client.id, 'm', TRIGGER)));
    await room.put('/in', 1);
    expect(room.outputs.at(-1)).toEqual(['/out/m', { x: 1, y: expect.any(Number) as number }]);
    const [, before] = room.outputs.at(-1) as [string, { y: number }];
    room.world.isDown = true;
    await room.world.drop();
    room.world.isDown = false;
    await room.pass(5_000);
    expect(client.state.status).toBe('connected');
    expect(await room.stateOf(session)).toBe(SessionState.SESSION_RUNNING);
    await room.put('/in', 2);
    // With the state it had.
    expect(room.outputs.at(-1)).toMatchObject(['/out/m', { x: 2 }]);
    expect((room.outputs.at(-1) as [string, { y: number }])[1].y).toBeGreaterThan(before.y);

    const closed = client.close();
    await room.pass(100);
    await closed;
    await room.pass(100);
    expect(await room.stateOf(session)).toBe(SessionState.SESSION_DEGRADED);
    await node.stop();
  });

  it('holds its modules while the session is paused [SE-14]', async () => {
    const room = await NodeWorld.create();
    const { client } = await room.joinAsNode('node');
    const session = await room.start(sessionOf(counter(client.id, 'm', TRIGGER)));
    await room.put('/in', 1);
    const ask = async (service: 'sessionPause' | 'sessionResume'): Promise<void> => {
      const asked = room.ada.call(service, { id: session.id });
      await room.pass();
      await asked;
      await room.pass();
    };
    await ask('sessionPause');
    const count = room.outputs.length;
    await room.put('/in', 2);
    expect(room.outputs).toHaveLength(count);
    expect(await room.stateOf(session)).toBe(SessionState.SESSION_PAUSED);
    await ask('sessionResume');
    await room.put('/in', 3);
    expect(room.outputs.at(-1)).toMatchObject(['/out/m', { x: 3 }]);
  });

  it('applies other mappings without losing the state of its modules [SE-15] [PM-62]', async () => {
    const room = await NodeWorld.create();
    const { client } = await room.joinAsNode('node');
    const session = await room.start(sessionOf(counter(client.id, 'm', TRIGGER)));
    await room.put('/in', 1);
    const [, { y: before }] = room.outputs.at(-1) as [string, { y: number }];
    await room.update(withInput(session, '/other'));
    await room.put('/other', 5);
    const [, { x, y }] = room.outputs.at(-1) as [string, { x: number; y: number }];
    expect([x, y > before]).toEqual([5, true]);
  });

  it('restarts a module that needs other libraries, which is no failure [SE-15] [PM-62]', async () => {
    const room = await NodeWorld.create();
    const { client } = await room.joinAsNode('node', { http: {} });
    await room.put('/in', 1);
    const session = await room.start(sessionOf(counter(client.id, 'm', TRIGGER)));
    await room.put('/in', 2);
    const states = new Set<SessionState | undefined>();
    const changes = room.ada.subscribe('/info/session/change', { format: 'session' });
    changes.onRecord(({ value }) => states.add(value.extension?.state));
    session.processingModules[0]!.extension!.libraries = ['http'];
    const { extension } = await room.update(session);
    expect(extension?.problems).toEqual([]);
    expect([...states]).toEqual([SessionState.SESSION_RUNNING]);
    await room.put('/in', 3);
    expect(room.outputs.slice(-2)).toEqual([
      ['/out/m', { x: 2, y: 1 }],
      ['/out/m', { x: 3, y: 2 }],
    ]);
  });

  it('tries a module that failed again when the session is updated [SE-15]', async () => {
    const room = await NodeWorld.create();
    const { client, node } = await room.joinAsNode('node');
    let failures = 0;
    node.onEvent(({ kind }) => {
      if (kind === ModuleEventKind.FAILED) failures += 1;
    });
    const bad = {
      ...counter(client.id, 'bad', TRIGGER),
      onCreatedStringified: '() => { throw new Error("no camera"); }',
    };
    const session = await room.start(sessionOf(bad, counter(client.id, 'good', TRIGGER)));
    expect(failures).toBe(1);
    await room.update(withInput(session, '/other'));
    expect(failures).toBe(2);
    await room.pass(11_000);
    const { extension } = await room.get(session.id);
    const [problem] = extension?.problems.filter(({ moduleName }) => moduleName === 'bad') ?? [];
    expect(problem?.message).toMatch(/does not run: no camera/);
  });

  it('ends the topics of its outputs with the session, but for those of another session [SE-63]', async () => {
    const room = await NodeWorld.create();
    const { client } = await room.joinAsNode('node');
    const { id } = await room.start(
      sessionOf(counter(client.id, 'm', TRIGGER), counter(client.id, 'both', TRIGGER)),
    );
    await room.start({ ...sessionOf(counter(client.id, 'both', TRIGGER)), name: 'other' });
    await room.put('/in', 1);
    await room.call('sessionRuntimeStop', { id });
    expect(await room.topics()).toEqual(['/in', '/out/both', '/out/m']);
    await room.call('sessionRuntimeRemove', { id });
    expect(await room.topics()).toEqual(['/in', '/out/both']);
  });

  it('lets topics go whose value was deleted [PM-44] [TD-42]', async () => {
    const room = await NodeWorld.create();
    const { client } = await room.joinAsNode('node');
    const { client: player } = await room.world.connect('player');
    await room.start({
      name: 'players',
      processingModules: [
        {
          name: 'count',
          nodeId: client.id,
          processingMode: { frequency: { hertz: 10 } },
          inputs: [{ internalName: 'all', messageFormat: 'double', isRecordList: true }],
          outputs: [{ internalName: 'out', messageFormat: 'double' }],
          onProcessingStringified:
            '(dt, inputs) => ({ outputs: { out: { double: inputs.all.elements.length } } })',
        },
      ],
      ioMappings: [
        {
          processingModuleName: 'count',
          inputMappings: [{ inputName: 'all', topicMux: { topicGlob: '/player/*' } }],
          outputMappings: [{ outputName: 'out', topic: '/out/count' }],
        },
      ],
    });
    player.publish('/player/1', 'double', 1);
    await room.put('/player/2', 1);
    await room.pass(300);
    expect(room.outputs.at(-1)).toEqual(['/out/count', 2]);
    const closed = player.close();
    await room.pass(100);
    await closed;
    await room.pass(300);
    expect(room.outputs.at(-1)).toEqual(['/out/count', 1]);
  });

  it('says why a module cannot be made, and the session tells it [SE-12]', async () => {
    const room = await NodeWorld.create();
    const { client } = await room.joinAsNode('node');
    const session = await room.start(
      sessionOf(
        {
          ...counter(client.id, 'bad', TRIGGER),
          onCreatedStringified: '() => { throw new Error("no camera"); }',
        },
        counter(client.id, 'good', TRIGGER),
      ),
    );
    await room.pass(100);
    const { extension } = await room.get(session.id);
    expect(extension?.state).toBe(SessionState.SESSION_DEGRADED);
    expect(extension?.problems.find(({ moduleName }) => moduleName === 'bad')).toMatchObject({
      isError: true,
      nodeId: client.id,
      message: expect.stringContaining('no camera') as string,
    });
    await room.put('/in', 3);
    expect(room.outputs.at(-1)).toMatchObject(['/out/good', { x: 3 }]);
  });

  it.each([
    ['triggered', TRIGGER],
    ['in lockstep', { lockstep: {} }],
  ])('ends the topics of demuxers with their session, %s [SE-63]', async (_what, mode) => {
    const world = await NodeWorld.create();
    const { client } = await world.joinAsNode('node');
    const session = sessionOf({
      ...counter(client.id, 'spread', mode),
      outputs: [{ internalName: 'out', messageFormat: 'double' }],
      onProcessingStringified: `() => ({ outputs: { out: { elements: ['a', 'b'].map((name) => (
        { double: 1, outputTopicParams: [name] })) } } })`,
    });
    const outputMappings = [
      { outputName: 'out', topicDemux: { outputTopicFormat: '/out/{{#0}}' } },
    ];
    const { id } = await world.start({
      ...session,
      ioMappings: session.ioMappings!.map((mapping) => ({ ...mapping, outputMappings })),
    });
    await world.put('/in', 1);
    await world.pass(500);
    const topics = async (): Promise<string[]> => {
      const listed = world.ada.call('topicList');
      await world.pass();
      return (await listed).elements.filter((topic) => topic.startsWith('/out/'));
    };
    expect(await topics()).toEqual(['/out/a', '/out/b']);
    void world.ada.call('sessionRuntimeStop', { id });
    await world.pass(500);
    expect(await topics()).toEqual([]);
  });
});
