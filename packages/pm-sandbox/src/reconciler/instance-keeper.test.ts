import { decode, encode, ProcessingModuleStatus, type ProcessingModule } from '@ubii/proto';
import { readyPatterns, LazyPatterns, type PatternCompiler } from '@ubii/patterns';
import { settle } from '@ubii/timing/testing';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { InstanceSpec, ModuleRuntime } from '../runtime/module-runtime.ts';
import { InstanceKeeper, type InstanceKeeperContext } from './instance-keeper.ts';
import type { WantedInstance } from './reconcile.ts';

const MODULE = 'ubii.processing.ProcessingModule';
const NO_MAPPING = decode('ubii.sessions.IOMapping', new Uint8Array());
const FAULT: ModuleFault = { kind: 'threw', phase: 'onCreated', message: 'no luck' };

function wanted(
  id: string,
  module: Partial<ProcessingModule> = {},
  rest: Partial<WantedInstance> = {},
): WantedInstance {
  const spec = {
    module: decode(MODULE, encode(MODULE, { id, sessionId: 's', ...module })),
    mapping: NO_MAPPING,
    isTrusted: false,
  };
  return { spec, isPaused: false, revision: 1, ...rest };
}

/** A runtime that says what it was told, and takes the time it is given. */
function createWorld(options: Partial<InstanceKeeperContext> = {}) {
  const calls: string[] = [];
  const told: string[] = [];
  const broken = new Set<string>();
  const present = new Map<string, { spec: InstanceSpec; isProcessing: boolean }>();
  let work: () => Promise<void> = () => Promise.resolve();
  const call = async (kind: string, id: string): Promise<void> => {
    calls.push(`${kind} ${id}`);
    await work();
    if (broken.has(`${kind} ${id}`)) throw FAULT;
  };
  const runtime: Partial<ModuleRuntime> = {
    async create(spec) {
      const { id } = spec.module;
      if (present.has(id)) throw new Error(`the instance ${id} exists already`);
      await call('create', id);
      present.set(id, { spec, isProcessing: false });
    },
    start(id) {
      calls.push(`start ${id}`);
      present.get(id)!.isProcessing = true;
    },
    async halt(id) {
      await call('halt', id);
      present.get(id)!.isProcessing = false;
    },
    async destroy(id) {
      present.delete(id);
      await call('destroy', id);
    },
    remap(id, mapping) {
      calls.push(`remap ${id}`);
      if (broken.has(`remap ${id}`)) throw FAULT;
      const { spec, isProcessing } = present.get(id)!;
      present.set(id, { spec: { ...spec, mapping }, isProcessing });
    },
    setMode(id, processingMode) {
      calls.push(`mode ${id}`);
      const { spec, isProcessing } = present.get(id)!;
      const module = { ...spec.module, processingMode };
      present.set(id, { spec: { ...spec, module }, isProcessing });
    },
  };
  const keeper = new InstanceKeeper({
    runtime: () => runtime as ModuleRuntime,
    onStarted: ({ spec }) => told.push(`started ${spec.module.id}`),
    onEnded: ({ spec }, isWanted) =>
      told.push(`ended ${spec.module.id}${isWanted ? ' for now' : ''}`),
    onFailed: ({ spec }, { message }) => told.push(`failed ${spec.module.id}: ${message}`),
    onGone: (id) => told.push(`gone ${id}`),
    ...options,
  });
  return {
    keeper,
    calls,
    told,
    broken,
    present,
    setWork: (fn: () => Promise<void>) => (work = fn),
  };
}

describe('InstanceKeeper', () => {
  it('takes all that is said in one turn as one', async () => {
    const { keeper, calls, told } = createWorld();
    keeper.sync('s', [wanted('a')]);
    keeper.sync('s', [wanted('b')]);
    keeper.sync('s', [wanted('a')]);
    await keeper.settled();
    expect(calls).toEqual(['create a', 'start a']);
    expect(told.sort()).toEqual(['ended b', 'gone b', 'started a']);
  });

  it('works out the steps again when something else is wanted meanwhile [PM-62]', async () => {
    const { keeper, calls, told, setWork } = createWorld();
    let open = (): void => undefined;
    setWork(() => new Promise((resolve) => (open = resolve)));
    keeper.sync('s', [wanted('a')]);
    await settle();
    keeper.sync('s', [wanted('a', { onProcessingStringified: '() => 2' })]);
    setWork(() => Promise.resolve());
    open();
    await keeper.settled();
    expect(calls).toEqual(['create a', 'destroy a', 'create a', 'start a']);
    expect(told).toEqual(['ended a for now', 'started a']);
  });

  it('may be told what else is wanted by who hears of a start', async () => {
    const world = createWorld({
      onStarted: ({ spec }) => {
        if (spec.module.id === 'a') world.keeper.sync('s', [wanted('a')]);
      },
    });
    world.keeper.sync('s', [wanted('a'), wanted('b')]);
    await world.keeper.settled();
    expect([...world.present.keys()]).toEqual(['a']);
    expect(world.told).toEqual(['ended b', 'gone b']);
  });

  it('lets no instance wait for another one', async () => {
    const { keeper, told, setWork } = createWorld();
    setWork(() => new Promise(() => undefined));
    keeper.sync('s', [wanted('slow')]);
    await settle();
    setWork(() => Promise.resolve());
    keeper.sync('s', [wanted('slow'), wanted('quick')]);
    await settle();
    expect(told).toEqual(['started quick']);
  });

  it('tells what cannot be changed while it runs as failed [SE-12]', async () => {
    const { keeper, told, broken } = createWorld();
    keeper.sync('s', [wanted('a')]);
    await keeper.settled();
    broken.add('remap a');
    const { spec } = wanted('a');
    const mapping = { ...NO_MAPPING, processingModuleName: 'other' };
    keeper.sync('s', [{ ...wanted('a'), spec: { ...spec, mapping } }]);
    await keeper.settled();
    expect(told).toEqual(['started a', 'failed a: no luck']);
    expect(keeper.has('a')).toBe(false);
    expect(keeper.started).toEqual([]);
  });

  it('reports nothing as started that its runtime gave up [PM-54]', async () => {
    const { keeper, calls, present } = createWorld();
    const { DESTROYED, INITIALIZED } = ProcessingModuleStatus;
    keeper.sync('s', [wanted('a')]);
    await keeper.settled();
    expect(keeper.handleStatus('a', INITIALIZED, FAULT)).toBe(true);
    expect(keeper.started).toHaveLength(1);
    expect(keeper.handleStatus('a', DESTROYED, FAULT)).toBe(true);
    expect(keeper.started).toEqual([]);
    keeper.sync('s', [wanted('a', {}, { revision: 2 })]);
    await keeper.settled();
    expect(calls.slice(2)).toEqual(['destroy a', 'create a', 'start a']);
    expect(present.get('a')?.isProcessing).toBe(true);
    expect(keeper.started).toHaveLength(1);
    expect(keeper.handleStatus('unknown', DESTROYED, FAULT)).toBe(false);
  });

  it('ends the instances of sessions that are no more', async () => {
    const { keeper, calls } = createWorld();
    keeper.sync('s', [wanted('a')]);
    keeper.sync('t', [wanted('b', { sessionId: 't' })]);
    await keeper.settled();
    keeper.keepSessions(new Set(['t']));
    await keeper.settled();
    expect(calls.at(-1)).toBe('destroy a');
    expect(keeper.has('b')).toBe(true);
  });

  it('takes no step after it was closed', async () => {
    const { keeper, calls } = createWorld();
    keeper.sync('s', [wanted('a')]);
    await settle();
    keeper.close();
    keeper.sync('s', []);
    await keeper.settled();
    expect(calls).toEqual(['create a', 'start a']);
  });

  it('loads patterns before an instance whose muxers need them [TD-64]', async () => {
    const steps: string[] = [];
    const compiler: PatternCompiler = readyPatterns({
      compile: () => ({ test: () => true }),
    } as never).compiler!;
    const patterns = new LazyPatterns(() => {
      steps.push('load');
      return Promise.resolve(compiler);
    });
    const { keeper, calls } = createWorld({ patterns });
    const mapping = decode(
      'ubii.sessions.IOMapping',
      encode('ubii.sessions.IOMapping', {
        inputMappings: [{ inputName: 'all', topicMux: { topicSelector: '^/x/' } }],
      }),
    );
    keeper.sync('s', [wanted('plain')]);
    await keeper.settled();
    expect(steps).toEqual([]);
    const { spec } = wanted('muxed');
    keeper.sync('t', [{ ...wanted('muxed'), spec: { ...spec, mapping } }]);
    await keeper.settled();
    expect(steps).toEqual(['load']);
    expect(calls.at(-1)).toBe('start muxed');
  });
});

it('whatever is wanted and whenever, there is in the end what was wanted last', async () => {
  const one = fc.record({
    id: fc.constantFrom('a', 'b', 'c'),
    code: fc.constantFrom('() => 1', '() => 2'),
    hertz: fc.constantFrom(10, 20),
    label: fc.constantFrom('x', 'y'),
    isPaused: fc.boolean(),
  });
  const sync = fc.record({
    list: fc.uniqueArray(one, { selector: ({ id }) => id }),
    turns: fc.nat(3),
    broken: fc.subarray(['create a', 'halt b', 'remap b', 'destroy c']),
  });
  const instanceOf = (
    { id, code, hertz, label, isPaused }: typeof one extends fc.Arbitrary<infer T> ? T : never,
    revision: number,
  ): WantedInstance => {
    const processingMode = decode(
      'ubii.processing.ProcessingMode',
      encode('ubii.processing.ProcessingMode', { frequency: { hertz } }),
    );
    const { spec } = wanted(id, { onProcessingStringified: code, processingMode });
    const mapping = { ...NO_MAPPING, processingModuleName: label };
    return { spec: { ...spec, mapping }, isPaused, revision };
  };
  await fc.assert(
    fc.asyncProperty(fc.array(sync, { minLength: 1, maxLength: 8 }), async (syncs) => {
      const world = createWorld();
      world.setWork(() => settle());
      for (const [revision, { list, turns, broken }] of syncs.entries()) {
        world.broken.clear();
        for (const call of broken) world.broken.add(call);
        world.keeper.sync(
          's',
          list.map((each) => instanceOf(each, revision)),
        );
        for (let i = 0; i < turns; i++) await settle();
      }
      // Once more without faults: what failed is tried again.
      world.broken.clear();
      const last = syncs.at(-1)!.list.map((each) => instanceOf(each, syncs.length));
      world.keeper.sync('s', last);
      await world.keeper.settled();
      const byId = (a: { spec: InstanceSpec }, b: { spec: InstanceSpec }) =>
        a.spec.module.id < b.spec.module.id ? -1 : 1;
      expect([...world.present.values()].sort(byId)).toEqual(
        last.map(({ spec, isPaused }) => ({ spec, isProcessing: !isPaused })).sort(byId),
      );
      for (const id of ['a', 'b', 'c']) {
        const isWanted = last.some(({ spec }) => spec.module.id === id);
        const news = world.told.filter((each) => each.split(' ')[1] === id);
        if (isWanted) expect(news.at(-1)).toBe(`started ${id}`);
        else if (news.length > 0) expect(news.slice(-2)).toEqual([`ended ${id}`, `gone ${id}`]);
      }
    }),
  );
});
