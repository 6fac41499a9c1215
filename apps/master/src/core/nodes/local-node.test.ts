import type { InstanceSpec, ModuleFault, ModuleRuntime, WantedInstance } from '@ubii/pm-sandbox';
import {
  decode,
  encode,
  ProcessingModuleStatus,
  type Init,
  type IOMapping,
  type ProcessingModule,
} from '@ubii/proto';
import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { LocalNode, type RuntimeHooks } from './local-node.ts';

const { DESTROYED, INITIALIZED, PROCESSING } = ProcessingModuleStatus;
const FAULT: ModuleFault = { kind: 'threw', phase: 'onCreated', message: 'no luck', line: 3 };

/** A runtime that does what it is told when the test lets it. */
class FakeRuntime implements Partial<ModuleRuntime> {
  readonly calls: string[] = [];
  readonly hooks: RuntimeHooks;
  /** The next `create` waits for it. */
  gate: Promise<void> = Promise.resolve();
  fault: ModuleFault | undefined = undefined;

  constructor(hooks: RuntimeHooks) {
    this.hooks = hooks;
  }

  async create({ module }: InstanceSpec): Promise<void> {
    this.calls.push(`create ${module.id}`);
    await this.gate;
    if (this.fault !== undefined) throw this.fault;
  }

  start(id: string): void {
    this.calls.push(`start ${id}`);
  }

  halt(id: string): Promise<void> {
    this.calls.push(`halt ${id}`);
    return Promise.resolve();
  }

  destroy(id: string): Promise<void> {
    this.calls.push(`destroy ${id}`);
    return Promise.resolve();
  }

  remap(id: string): void {
    this.calls.push(`remap ${id}`);
  }

  setMode(id: string): void {
    this.calls.push(`mode ${id}`);
  }
}

function setup() {
  const reports: string[] = [];
  let runtime: FakeRuntime | undefined;
  const node = new LocalNode(
    (hooks) => (runtime = new FakeRuntime(hooks)) as unknown as ModuleRuntime,
  );
  node.onStarted.add((id) => reports.push(`started ${id}`));
  node.onStopped.add((id) => reports.push(`stopped ${id}`));
  node.onFailed.add((id, reason) => reports.push(`failed ${id}: ${reason}`));
  return {
    node,
    reports,
    get runtime(): FakeRuntime {
      if (runtime === undefined) throw new Error('nothing ran');
      return runtime;
    },
    /** Returns the calls of the runtime since the last time. */
    async take(): Promise<string[]> {
      await settle();
      return runtime?.calls.splice(0) ?? [];
    },
  };
}

function wanted(
  id: string,
  module: Init<ProcessingModule> = {},
  mapping: Init<IOMapping> = {},
): WantedInstance {
  const format = 'ubii.processing.ProcessingModule';
  const spec = {
    module: decode(format, encode(format, { id, onProcessingStringified: '() => 1', ...module })),
    mapping: decode('ubii.sessions.IOMapping', encode('ubii.sessions.IOMapping', mapping)),
    isTrusted: false,
  };
  return { spec, isPaused: false, revision: 1 };
}

describe('the master as a node', () => {
  it('makes no runtime before the first module', async () => {
    const world = setup();
    world.node.sync('s', []);
    expect(await world.take()).toEqual([]);
    expect(world.node.runtime).toBeUndefined();
  });

  it('makes and ends what the session says, and tells [SE-12] [SE-13]', async () => {
    const world = setup();
    world.node.sync('s', [wanted('a'), wanted('b')]);
    expect(await world.take()).toEqual(['create a', 'create b', 'start a', 'start b']);
    expect(world.reports.splice(0)).toEqual(['started a', 'started b']);
    world.node.sync('s', [wanted('b')]);
    expect(await world.take()).toEqual(['destroy a']);
    world.node.sync('other', []);
    expect(await world.take()).toEqual([]);
    world.node.sync('s', []);
    expect(await world.take()).toEqual(['destroy b']);
    expect(world.reports).toEqual(['stopped a', 'stopped b']);
    expect(world.node.isBusyWith('b')).toBe(false);
  });

  it('leaves alone what did not change, and applies what did [SE-15]', async () => {
    const world = setup();
    world.node.sync('s', [wanted('a')]);
    await world.take();
    world.node.sync('s', [wanted('a')]);
    expect(await world.take()).toEqual([]);
    world.node.sync('s', [wanted('a', {}, { inputMappings: [{ inputName: 'x' }] })]);
    expect(await world.take()).toEqual(['remap a']);
    world.node.sync('s', [wanted('a', { processingMode: { free: {} } })]);
    expect(await world.take()).toEqual(['remap a', 'mode a']);
    world.node.sync('s', [wanted('a', { onProcessingStringified: '() => 2' })]);
    expect(await world.take()).toEqual(['destroy a', 'create a', 'start a']);
  });

  it('holds, and goes on [SE-14]', async () => {
    const world = setup();
    world.node.sync('s', [wanted('a')]);
    await world.take();
    world.node.sync('s', [{ ...wanted('a'), isPaused: true }]);
    expect(await world.take()).toEqual(['halt a']);
    world.node.sync('s', [wanted('a')]);
    expect(await world.take()).toEqual(['start a']);
  });

  it('ends an instance that is not wanted any more as soon as it is created', async () => {
    const world = setup();
    world.node.sync('s', [wanted('first')]);
    await world.take();
    let open = (): void => undefined;
    world.runtime.gate = new Promise((resolve) => (open = resolve));
    world.node.sync('s', [wanted('a')]);
    expect(await world.take()).toContain('create a');
    world.node.sync('s', []);
    expect(world.node.isBusyWith('a')).toBe(true);
    open();
    expect(await world.take()).toEqual(['destroy a']);
    expect(world.reports).not.toContain('started a');
    expect(world.reports).toContain('stopped a');
  });

  it('tells what could not be made, and tries again when its session changes [SE-12] [SE-15]', async () => {
    const world = setup();
    world.node.sync('s', [wanted('first')]);
    await world.take();
    world.runtime.fault = FAULT;
    world.node.sync('s', [wanted('first'), wanted('a')]);
    expect(await world.take()).toEqual(['create a']);
    expect(world.reports).toContain('failed a: no luck');
    expect(world.node.isBusyWith('a')).toBe(false);
    world.node.sync('s', [wanted('first'), wanted('a')]);
    expect(await world.take()).toEqual([]);
    world.runtime.fault = undefined;
    world.node.sync('s', [wanted('first'), { ...wanted('a'), revision: 2 }]);
    expect(await world.take()).toEqual(['destroy a', 'create a', 'start a']);
  });

  it('makes an instance again that was not wanted for a moment [SE-13]', async () => {
    const world = setup();
    world.node.sync('s', [wanted('first')]);
    await world.take();
    let open = (): void => undefined;
    world.runtime.gate = new Promise((resolve) => (open = resolve));
    world.node.sync('s', [wanted('a')]);
    expect(await world.take()).toContain('create a');
    world.node.sync('s', []);
    world.node.sync('s', [wanted('a')]);
    open();
    expect(await world.take()).toEqual(['destroy a', 'create a', 'start a']);
    expect(world.reports.filter((report) => report.endsWith(' a'))).toEqual(['started a']);
  });

  it('tells the end of what was stopped before it could be made', async () => {
    const world = setup();
    world.node.sync('s', [wanted('a')]);
    expect(world.node.isBusyWith('a')).toBe(true);
    world.node.sync('s', []);
    expect(await world.take()).toEqual([]);
    expect(world.reports).toEqual(['stopped a']);
  });

  it('does not try what failed again because its session is paused [SE-14]', async () => {
    const world = setup();
    world.node.sync('s', [wanted('first')]);
    await world.take();
    world.runtime.fault = FAULT;
    const both = [wanted('first'), wanted('a')];
    world.node.sync('s', both);
    expect(await world.take()).toEqual(['create a']);
    world.node.sync(
      's',
      both.map((one) => ({ ...one, isPaused: true })),
    );
    expect(await world.take()).toEqual(['halt first']);
  });

  it('tells of what was killed, of its return, and of what was given up [PM-54]', async () => {
    const world = setup();
    world.node.sync('s', [wanted('a')]);
    await world.take();
    world.reports.splice(0);
    const { hooks } = world.runtime;
    hooks.onStatus('a', INITIALIZED, FAULT);
    hooks.onStatus('a', PROCESSING);
    hooks.onStatus('a', DESTROYED, FAULT);
    expect(world.reports).toEqual(['failed a: no luck', 'started a', 'failed a: no luck']);
    world.node.sync('s', [wanted('a')]);
    expect(await world.take()).toEqual([]);
    // The module has not changed, but its session has.
    world.node.sync('s', [{ ...wanted('a'), revision: 2 }]);
    expect(await world.take()).toEqual(['destroy a', 'create a', 'start a']);
  });
});
