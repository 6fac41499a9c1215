import { ModuleEventKind, ProcessingModuleStatus } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { EMPTY_RESULT, inputValues, sandboxOutput } from '../testing/fake-sandboxes.ts';
import { createAssetStore } from '../assets/asset-store.ts';
import { FakeAssets } from '../testing/fake-assets.ts';
import { createModuleWorld, instanceSpec, type ModuleWorld } from '../testing/module-world.ts';

const { INITIALIZED, CREATED, PROCESSING, HALTED, DESTROYED } = ProcessingModuleStatus;
const TEN_HERTZ = { frequency: { hertz: 10 } };
const ON_INPUT = { triggerOnInput: { minDelayMs: 0, allInputsNeedUpdate: false } };

const statuses = (world: ModuleWorld) => world.statuses.map(({ status }) => status);
const kinds = (world: ModuleWorld) => world.events.map(({ kind }) => kind);

describe('the asset sets of an instance [PM-90]', () => {
  const needing = { assets: ['model'], isTrusted: true };
  function world() {
    const source = new FakeAssets();
    source.add('model', { 'a.bin': 'abc' });
    return { source, ...createModuleWorld({}, [], { assets: createAssetStore(source) }) };
  }

  it('are loaded before its code, and how far that is, is told [PM-94]', async () => {
    const { sandboxes, begin, events } = world();
    await begin(needing);
    expect(sandboxes.last.request.assets.map(({ name }) => name)).toEqual(['model']);
    // Models take longer than other code. [PM-53]
    expect(sandboxes.last.request.limits.callTimeoutMs).toBe(5000);
    expect(events.map(({ message }) => message)).toEqual([
      'Loading the asset set model: 100 % of 0.0 MB.',
    ]);
  });

  it('are in its statistics while they load [PM-94]', async () => {
    const { source, runtime } = world();
    source.add('library', { 'b.js': '0123456789' });
    const pauses: (() => void)[] = [];
    Object.defineProperty(source, 'pause', {
      get: () => new Promise<void>((resolve) => pauses.push(resolve)),
    });
    const created = runtime.create(instanceSpec({ ...needing, assets: ['library', 'model'] }));
    const loading = () => {
      const [{ loadingSet, loadedBytes, loadingBytes } = {}] = runtime.statistics();
      return [loadingSet, loadedBytes, loadingBytes];
    };
    expect(loading()).toEqual(['', 0, 0]);
    await expect.poll(() => pauses.length).toBe(1);
    pauses[0]!();
    await expect.poll(() => pauses.length).toBe(2);
    expect(loading()).toEqual(['library', 10, 10]);
    pauses[1]!();
    await created;
    expect(loading()).toEqual(['', 0, 0]);
  });

  it('are for trusted modules only', async () => {
    const { runtime, sandboxes } = world();
    const created = runtime.create(instanceSpec({ ...needing, isTrusted: false }));
    await expect(created).rejects.toMatchObject({ kind: 'library', phase: 'onCreated' });
    expect(sandboxes.opened).toHaveLength(0);
  });

  it('are missing where a node loads none, or has no such set [PM-95]', async () => {
    const { runtime } = createModuleWorld();
    await expect(runtime.create(instanceSpec(needing))).rejects.toMatchObject({
      message: 'This node does not load asset sets.',
    });
    const other = world();
    const spec = instanceSpec({ ...needing, assets: ['none'] });
    await expect(other.runtime.create(spec)).rejects.toMatchObject({ kind: 'library' });
  });

  it('are not loaded to the end for a module that is stopped', async () => {
    const { source, runtime, sandboxes } = world();
    let go!: () => void;
    source.pause = new Promise((resolve) => (go = resolve));
    const created = runtime.create(instanceSpec(needing));
    void runtime.destroy('pm-1');
    await expect(created).rejects.toMatchObject({
      message: 'The module was stopped while its asset sets were loaded.',
    });
    go();
    expect(sandboxes.opened).toHaveLength(0);
  });
});

describe('the optional asset sets of an instance [PM-96]', () => {
  const asking = { optionalAssets: ['model'], isTrusted: true };
  function world() {
    const source = new FakeAssets();
    return { source, ...createModuleWorld({}, [], { assets: createAssetStore(source) }) };
  }

  it('are not loaded before the module asks, and may arrive after its start', async () => {
    const { source, sandboxes, begin, events } = world();
    await begin(asking);
    const load = () => sandboxes.last.events.onLoadAssets!('model');
    await expect(load()).rejects.toMatchObject({ code: 'missing' });
    expect(source.reads).toEqual([]);
    source.add('model', { 'a.bin': 'abc' });
    expect((await load()).name).toBe('model');
    expect(events.map(({ message }) => message)).toEqual([
      'Loading the asset set model: 100 % of 0.0 MB.',
    ]);
  });

  it('are those that the module lists, and no libraries', async () => {
    const { source, sandboxes, begin } = world();
    source.add('other', { 'a.bin': 'abc' });
    source.add('model', { 'a.js': '1' }, 'a.js');
    await begin(asking);
    const load = (name: string) => sandboxes.last.events.onLoadAssets!(name);
    await expect(load('other')).rejects.toThrow('does not list the asset set other');
    await expect(load('model')).rejects.toThrow('The asset set model is a library.');
    expect(source.reads).not.toContain('other/a.bin');
  });

  it('are for trusted modules only', async () => {
    const { runtime, sandboxes } = world();
    const created = runtime.create(instanceSpec({ ...asking, isTrusted: false }));
    await expect(created).rejects.toMatchObject({ kind: 'library', phase: 'onCreated' });
    expect(sandboxes.opened).toHaveLength(0);
  });

  it('are not loaded to the end for a module that ends', async () => {
    const { source, runtime, sandboxes, begin } = world();
    source.add('model', { 'a.bin': 'abc' });
    source.pause = new Promise(() => undefined);
    await begin(asking);
    const loading = sandboxes.last.events.onLoadAssets!('model');
    void runtime.destroy('pm-1');
    await expect(loading).rejects.toThrow('aborted');
  });
});

describe('the life of an instance', () => {
  it('[PM-10] is created, processes, is halted, processes again, and is destroyed', async () => {
    const world = createModuleWorld();
    const { clock, sandboxes, runtime } = world;
    sandboxes.onRun = () => EMPTY_RESULT;
    await world.begin({ mode: TEN_HERTZ });
    await runtime.halt('pm-1');
    await clock.advance(500);
    runtime.start('pm-1');
    await clock.advance(50);
    await runtime.destroy('pm-1');
    expect(sandboxes.last.journal).toEqual(['create', 'run', 'halt', 'run', 'halt', 'destroy']);
    expect(statuses(world)).toEqual([CREATED, PROCESSING, HALTED, PROCESSING, HALTED, DESTROYED]);
    expect(runtime.has('pm-1')).toBe(false);
    expect(clock.timerCount).toBe(0);
    expect(sandboxes.opened).toHaveLength(1);
  });

  it('[PM-10] is destroyed without onHalted when it never ran', async () => {
    const { sandboxes, runtime } = createModuleWorld();
    await runtime.create(instanceSpec());
    await runtime.destroy('pm-1');
    expect(sandboxes.last.journal).toEqual(['create', 'destroy']);
  });

  it('does not run before it is started', async () => {
    const { clock, sandboxes, runtime } = createModuleWorld();
    await runtime.create(instanceSpec({ mode: TEN_HERTZ }));
    await clock.advance(1000);
    expect(sandboxes.last.journal).toEqual(['create']);
  });

  it('starts once it is created when it was started before', async () => {
    const { clock, sandboxes, runtime } = createModuleWorld();
    const created = runtime.create(instanceSpec({ mode: TEN_HERTZ }));
    runtime.start('pm-1');
    await created;
    await clock.endTurn();
    expect(sandboxes.last.journal).toEqual(['create', 'run']);
  });

  it('[PM-29] lets the run under way end when it is halted, and publishes its outputs', async () => {
    const { clock, sandboxes, topics, runtime, begin } = createModuleWorld();
    await begin({ mode: TEN_HERTZ, outputs: { out: 'double' }, to: { out: '/out' } });
    let isHalted = false;
    const halted = runtime.halt('pm-1').then(() => {
      isHalted = true;
    });
    await clock.advance(1000);
    expect(isHalted).toBe(false);
    expect(sandboxes.last.journal).toEqual(['create', 'run']);
    sandboxes.last.finish({ outputs: [sandboxOutput('out', 'double', 5)] });
    await halted;
    expect(topics.published).toMatchObject([{ topic: '/out', value: 5 }]);
    expect(sandboxes.last.journal).toEqual(['create', 'run', 'halt']);
  });

  it('[PM-29] terminates what does not end in time after it was halted', async () => {
    const world = createModuleWorld({ haltTimeoutMs: 500 });
    await world.begin({ mode: TEN_HERTZ });
    const halted = world.runtime.halt('pm-1');
    await world.clock.advance(500);
    await halted;
    expect(world.sandboxes.last.isTerminated).toBe(true);
    expect(kinds(world)).toContain(ModuleEventKind.KILLED);
    await world.clock.advance(5000);
    expect(world.sandboxes.last.journal).toEqual(['create']);
    expect(statuses(world).at(-1)).toBe(CREATED);
  });

  it('[PM-29] waits as long for a last callback', async () => {
    const world = createModuleWorld({ haltTimeoutMs: 500 });
    world.sandboxes.onRun = () => EMPTY_RESULT;
    world.sandboxes.onDestroy = () => 'pending';
    await world.begin({ mode: TEN_HERTZ });
    const destroyed = world.runtime.destroy('pm-1');
    await world.clock.advance(1000);
    await destroyed;
    expect(world.sandboxes.last.isTerminated).toBe(true);
    expect(world.runtime.has('pm-1')).toBe(false);
    expect(world.clock.timerCount).toBe(0);
  });

  it('goes on when it is started again while it is halted', async () => {
    const world = createModuleWorld();
    await world.begin({ mode: TEN_HERTZ });
    const halted = world.runtime.halt('pm-1');
    world.runtime.start('pm-1');
    world.sandboxes.last.finish();
    await halted;
    await world.clock.endTurn();
    expect(world.sandboxes.last.journal).toEqual(['create', 'run', 'halt', 'run']);
  });

  it('[PM-13] goes on after a run that throws, which is counted and reported', async () => {
    const world = createModuleWorld();
    await world.begin({ mode: TEN_HERTZ });
    world.sandboxes.last.fail({ message: 'x is not defined', line: 3, column: 7 });
    await world.clock.advance(100);
    expect(world.sandboxes.last.calls).toHaveLength(2);
    expect(world.events).toMatchObject([
      {
        kind: ModuleEventKind.ERROR,
        sessionId: 'session-1',
        moduleId: 'pm-1',
        moduleName: 'module',
        nodeId: 'node-1',
        phase: 'onProcessing',
        message: 'x is not defined',
        line: 3,
        column: 7,
        timeMs: world.clock.nowMs() - 100,
      },
    ]);
    expect(world.runtime.statistics()[0]).toMatchObject({ errors: 1, runs: 2 });
  });

  it.each(['onHalt', 'onDestroy'] as const)('[PM-13] goes on when %s throws', async (callback) => {
    const world = createModuleWorld();
    world.sandboxes.onRun = () => EMPTY_RESULT;
    world.sandboxes[callback] = () => ({ kind: 'threw', phase: 'onHalted', message: 'no' });
    await world.begin({ mode: TEN_HERTZ });
    await world.runtime.destroy('pm-1');
    expect(world.sandboxes.last.journal).toEqual(['create', 'run', 'halt', 'destroy']);
    expect(world.events).toMatchObject([{ kind: ModuleEventKind.ERROR, message: 'no' }]);
  });

  it('[PM-13] cannot start when onCreated throws', async () => {
    const world = createModuleWorld();
    const fault = { kind: 'threw', phase: 'onCreated', message: 'no' } as const;
    world.sandboxes.onCreate = () => fault;
    await expect(world.runtime.create(instanceSpec())).rejects.toBe(fault);
    expect(world.runtime.has('pm-1')).toBe(false);
    expect(world.topics.subscriptionCount).toBe(0);
    expect(world.statuses).toEqual([{ id: 'pm-1', status: DESTROYED, fault }]);
    expect(world.clock.timerCount).toBe(0);
  });

  it('[PM-1] cannot start without onProcessing', async () => {
    const { runtime } = createModuleWorld();
    const spec = instanceSpec();
    const module = { ...spec.module, onProcessingStringified: ' ' };
    await expect(runtime.create({ ...spec, module })).rejects.toMatchObject({ kind: 'missing' });
  });

  it('[PM-4] cannot start on a node that lacks a library', async () => {
    const { runtime } = createModuleWorld({}, ['http']);
    await runtime.create(instanceSpec({ libraries: ['http'] }));
    await expect(
      runtime.create(instanceSpec({ id: 'pm-2', libraries: ['http', 'tfjs'] })),
    ).rejects.toMatchObject({ kind: 'library', message: expect.stringMatching(/ tfjs\.$/) });
  });

  it('refuses a second instance of an id', async () => {
    const { runtime } = createModuleWorld();
    await runtime.create(instanceSpec());
    await expect(runtime.create(instanceSpec())).rejects.toBeInstanceOf(Error);
    expect(runtime.instanceCount).toBe(1);
  });

  it('ends all instances when it is closed, also one that is being created', async () => {
    const world = createModuleWorld();
    await world.begin({ mode: { free: {} } });
    world.sandboxes.onCreate = () => 'pending';
    void world.runtime.create(instanceSpec({ id: 'pm-2' })).catch(() => {});
    const closed = world.runtime.close();
    world.sandboxes.of('pm-1').finish();
    await closed;
    expect(world.sandboxes.of('pm-2').isTerminated).toBe(true);
    expect(world.runtime.instanceCount).toBe(0);
    expect(world.topics.subscriptionCount).toBe(0);
    expect(world.clock.timerCount).toBe(0);
  });
});

describe('[PM-54] a killed instance', () => {
  it('is created again with an empty state, after a delay, and goes on in its mode', async () => {
    const world = createModuleWorld({ restartDelayMs: 250 });
    const { clock, sandboxes, topics } = world;
    await world.begin({ mode: ON_INPUT, inputs: { a: 'double' }, from: { a: '/a' } });
    topics.put('/a', 'double', 1);
    await clock.endTurn();
    const first = sandboxes.last;
    first.kill({ kind: 'memory', message: 'too much', line: 4 });
    await clock.advance(249);
    expect(sandboxes.opened).toHaveLength(1);
    await clock.advance(1);
    expect(sandboxes.opened).toHaveLength(2);
    expect(sandboxes.opened.map(({ request }) => request.previousFault?.message)).toEqual([
      undefined,
      'too much',
    ]);
    expect(first.isTerminated).toBe(true);
    expect(sandboxes.last.calls.map(inputValues)).toEqual([{ a: 1 }]);
    expect(sandboxes.last.lastCall?.deltaTimeMs).toBe(0);
    expect(world.events).toMatchObject([
      { kind: ModuleEventKind.KILLED, message: 'too much', line: 4 },
      { kind: ModuleEventKind.RESTARTED },
    ]);
    expect(statuses(world)).toEqual([CREATED, PROCESSING, INITIALIZED, CREATED, PROCESSING]);
    expect(world.runtime.statistics()[0]).toMatchObject({ restarts: 1, errors: 1 });
  });

  it('waits longer each time, fails after too many, and stays so', async () => {
    const world = createModuleWorld({
      maxRestarts: 3,
      restartDelayMs: 100,
      maxRestartDelayMs: 300,
    });
    const { clock, sandboxes } = world;
    await world.begin({ mode: TEN_HERTZ });
    for (const delayMs of [100, 200, 300]) {
      const before = sandboxes.opened.length;
      sandboxes.last.kill();
      await clock.advance(delayMs - 1);
      expect(sandboxes.opened).toHaveLength(before);
      await clock.advance(1);
      expect(sandboxes.opened).toHaveLength(before + 1);
    }
    sandboxes.last.kill();
    await clock.advance(100_000);
    world.runtime.start('pm-1');
    await clock.advance(100_000);
    expect(sandboxes.opened).toHaveLength(4);
    expect(world.events.at(-1)).toMatchObject({ kind: ModuleEventKind.FAILED });
    expect(world.statuses.at(-1)).toMatchObject({ status: DESTROYED, fault: { kind: 'timeout' } });
    expect(world.runtime.has('pm-1')).toBe(true);
    expect(world.topics.subscriptionCount).toBe(0);
    await world.runtime.destroy('pm-1');
    expect(world.runtime.has('pm-1')).toBe(false);
  });

  it('is restarted again when the last restarts are long ago', async () => {
    const limits = { maxRestarts: 2, restartDelayMs: 100, restartWindowMs: 1000 };
    const world = createModuleWorld(limits);
    await world.begin({ mode: TEN_HERTZ });
    for (let i = 0; i < 5; i++) {
      world.sandboxes.last.kill();
      await world.clock.advance(1000);
    }
    expect(world.sandboxes.opened).toHaveLength(6);
  });

  it('counts a restart whose onCreated fails as killed again', async () => {
    const world = createModuleWorld({ maxRestarts: 2, restartDelayMs: 100 });
    await world.begin({ mode: TEN_HERTZ });
    world.sandboxes.onCreate = () => ({ kind: 'threw', phase: 'onCreated', message: 'no' });
    world.sandboxes.last.kill();
    await world.clock.advance(10_000);
    expect(world.sandboxes.opened).toHaveLength(3);
    expect(world.statuses.at(-1)).toMatchObject({ status: DESTROYED });
  });

  it('subscribes to nothing when it is mapped otherwise after it has failed', async () => {
    const world = createModuleWorld({ maxRestarts: 0 });
    await world.begin({ mode: TEN_HERTZ });
    world.sandboxes.last.kill();
    world.runtime.remap('pm-1', instanceSpec({ from: { x: '/x' } }).mapping);
    expect(world.topics.subscriptionCount).toBe(0);
  });

  it('is not created again when it was destroyed meanwhile', async () => {
    const world = createModuleWorld();
    await world.begin({ mode: TEN_HERTZ });
    world.sandboxes.last.kill();
    await world.runtime.destroy('pm-1');
    await world.clock.advance(10_000);
    expect(world.sandboxes.opened).toHaveLength(1);
    expect(world.clock.timerCount).toBe(0);
  });

  it('leaves the others running', async () => {
    const world = createModuleWorld();
    world.sandboxes.onRun = () => EMPTY_RESULT;
    await world.begin({ id: 'pm-1', mode: TEN_HERTZ });
    await world.begin({ id: 'pm-2', mode: TEN_HERTZ });
    world.sandboxes.of('pm-1').kill();
    await world.clock.advance(200);
    expect(world.sandboxes.of('pm-2').calls).toHaveLength(3);
  });

  it('is killed when a run is lost with its worker, also without a report', async () => {
    const world = createModuleWorld({ restartDelayMs: 100 });
    await world.begin({ mode: TEN_HERTZ });
    world.sandboxes.last.fail({ kind: 'crashed', message: 'the worker ended' });
    await world.clock.advance(100);
    expect(world.sandboxes.opened).toHaveLength(2);
    expect(kinds(world)).toEqual([ModuleEventKind.KILLED, ModuleEventKind.RESTARTED]);
    expect(world.runtime.statistics()[0]).toMatchObject({ errors: 1, restarts: 1 });
  });
});

describe('what fails around an instance', () => {
  it('ends the instance whose outputs cannot be taken, not the node', async () => {
    const world = createModuleWorld();
    const sketch = { mode: TEN_HERTZ, outputs: { out: 'double' }, to: { out: '/out' } };
    await world.begin(sketch);
    world.topics.publish = () => {
      throw new Error('broken port');
    };
    world.sandboxes.last.finish({ outputs: [sandboxOutput('out', 'double', 1)] });
    await world.clock.endTurn();
    expect(world.events).toMatchObject([{ kind: ModuleEventKind.KILLED, message: 'broken port' }]);
    expect(world.sandboxes.last.isTerminated).toBe(true);
  });

  it('tells when there is no sandbox to be had', async () => {
    const world = createModuleWorld();
    world.sandboxes.open = () => {
      throw new Error('closed');
    };
    const created = world.runtime.create(instanceSpec());
    await expect(created).rejects.toMatchObject({ kind: 'crashed', message: 'closed' });
    expect(world.runtime.has('pm-1')).toBe(false);
  });
});

describe('changes to a running instance', () => {
  it('[PM-62] takes another mode without a restart', async () => {
    const { clock, sandboxes, topics, runtime, begin } = createModuleWorld();
    sandboxes.onRun = () => EMPTY_RESULT;
    await begin({ mode: TEN_HERTZ, inputs: { a: 'double' }, from: { a: '/a' } });
    runtime.setMode('pm-1', ON_INPUT);
    await clock.advance(1000);
    expect(sandboxes.last.calls).toHaveLength(1);
    topics.put('/a', 'double', 1);
    await clock.endTurn();
    expect(sandboxes.last.calls).toHaveLength(2);
    runtime.setMode('pm-1', undefined);
    await clock.advance(1000);
    expect(sandboxes.last.calls.length).toBeGreaterThan(30);
    expect(sandboxes.last.journal.filter((name) => name !== 'run')).toEqual(['create']);
  });

  it('keeps its beat when the mode stays the same', async () => {
    const { clock, sandboxes, runtime, begin } = createModuleWorld();
    sandboxes.onRun = () => EMPTY_RESULT;
    await begin({ mode: TEN_HERTZ });
    await clock.advance(50);
    runtime.setMode('pm-1', { frequency: { hertz: 10 } });
    await clock.advance(49);
    expect(sandboxes.last.calls).toHaveLength(1);
    await clock.advance(1);
    expect(sandboxes.last.calls).toHaveLength(2);
  });

  it('takes another mode during a run, which is no overrun', async () => {
    const { clock, sandboxes, runtime, begin } = createModuleWorld();
    await begin({ mode: { free: {} } });
    await clock.advance(0);
    runtime.setMode('pm-1', TEN_HERTZ);
    sandboxes.last.finish();
    await clock.advance(100);
    expect(sandboxes.last.calls).toHaveLength(2);
    expect(runtime.statistics()[0]?.overruns).toBe(0);
  });
});
