import { Re2Patterns } from '@ubii/patterns/re2';
import { fromJson, ModuleEventKind, type ModuleEvent } from '@ubii/proto';
import { SystemClock } from '@ubii/timing/system';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { createModuleRuntime, type ModuleRuntime, type SandboxFactory } from '../src/index.ts';
import { createNodeSandboxes } from '../src/node/index.ts';
import { FakeTopics, ioMapping } from '../src/testing/index.ts';
import { WORKER_FILE } from './build-worker.ts';

const CLOCK = new SystemClock({ endTurn: (fn) => void setImmediate(fn) });

const ON_INPUT = { triggerOnInput: {} };

/** The runtime with threads of Node, and the time of the system. */
describe('modules on threads', () => {
  let sandboxes: SandboxFactory;
  let runtime: ModuleRuntime;
  let topics: FakeTopics;
  let events: ModuleEvent[];
  let waiters: (() => void)[];

  /** Resolves when the condition holds after something happened. */
  async function until(holds: () => boolean): Promise<void> {
    while (!holds()) await new Promise<void>((resolve) => waiters.push(resolve));
  }
  const wake = () => waiters.splice(0).forEach((resolve) => resolve());
  const countOf = (kind: ModuleEventKind, id: string) =>
    events.filter((event) => event.kind === kind && event.moduleId === id).length;
  const newest = (topic: string) =>
    topics.published.findLast((record) => record.topic === topic)?.value;

  beforeEach(() => {
    sandboxes = createNodeSandboxes({ workerFile: WORKER_FILE, maxWorkers: 2 });
    topics = new FakeTopics('node-1');
    events = [];
    waiters = [];
    topics.subscribe(
      { kind: 'glob', glob: '**' },
      { onRecord: () => setImmediate(wake), onGone: wake },
    );
    runtime = createModuleRuntime({
      nodeId: 'node-1',
      clock: CLOCK,
      topics,
      sandboxes,
      patterns: new Re2Patterns(),
      limits: { callTimeoutMs: 200, haltTimeoutMs: 300, restartDelayMs: 20, maxRestarts: 2 },
      onEvent: (event) => {
        events.push(event);
        wake();
      },
      onStatus: () => wake(),
    });
  });

  afterEach(async () => {
    await runtime.close();
    await sandboxes.close();
  });

  async function begin(
    id: string,
    isTrusted: boolean,
    processingMode: object,
    onProcessingStringified: string,
  ): Promise<void> {
    const module = fromJson('ubii.processing.ProcessingModule', {
      id,
      name: id,
      processingMode,
      onProcessingStringified,
      inputs: [{ internalName: 'x', messageFormat: 'double' }],
      outputs: [{ internalName: 'y', messageFormat: 'double' }],
    });
    const mapping = ioMapping({ id, from: { x: '/x' }, to: { y: `/${id}` } });
    await runtime.create({ module, mapping, isTrusted });
    runtime.start(id);
  }

  it.each([true, false])(
    '[PM-53] [PM-54] an endless loop is ended, restarted and given up; others run on; trusted: %s',
    async (isTrusted) => {
      const loop = '(_, { x }) => { while (x.double === 1); return { outputs: { y: x } }; }';
      const count =
        '(_, __, state) => { state.n = (state.n ?? 0) + 1; return { outputs: { y: { double: state.n } } }; }';
      await begin('counter', isTrusted, { frequency: { hertz: 100 } }, count);
      await begin('loop', isTrusted, ON_INPUT, loop);
      topics.put('/x', 'double', 5);
      await until(() => newest('/loop') === 5);
      topics.put('/x', 'double', 1);
      await until(() => countOf(ModuleEventKind.FAILED, 'loop') === 1);
      const before = newest('/counter') as number;
      await until(() => (newest('/counter') as number) > before + 10);
      expect(countOf(ModuleEventKind.KILLED, 'loop')).toBeGreaterThan(0);
      expect(countOf(ModuleEventKind.FAILED, 'counter')).toBe(0);
      const statistics = runtime.statistics().find(({ moduleId }) => moduleId === 'loop');
      expect(statistics).toMatchObject({ restarts: 2, errors: 3 });
    },
  );

  it.each([true, false])('every trigger is answered, in order; trusted: %s', async (isTrusted) => {
    const ids = Array.from({ length: 10 }, (_, i) => `echo-${i}`);
    for (const id of ids) {
      await begin(id, isTrusted, ON_INPUT, '(_, { x }) => ({ outputs: { y: x } })');
    }
    for (let value = 1; value <= 50; value++) {
      topics.put('/x', 'double', value);
      await until(() => ids.every((id) => newest(`/${id}`) === value));
    }
    expect(events).toEqual([]);
  });

  it('[PM-29] a callback that never ends is terminated when its session stops', async () => {
    // Trusted: QuickJS knows that such a promise can never settle, and ends the call at once.
    const stuck = '() => { console.log("stuck"); return new Promise(() => {}); }';
    await begin('stuck', true, { frequency: { hertz: 10 } }, stuck);
    await until(() => countOf(ModuleEventKind.LOG, 'stuck') === 1);
    expect(runtime.statistics()[0]?.runs).toBe(1);
    await runtime.destroy('stuck');
    expect(countOf(ModuleEventKind.KILLED, 'stuck')).toBe(1);
    expect(runtime.instanceCount).toBe(0);
  });
});
