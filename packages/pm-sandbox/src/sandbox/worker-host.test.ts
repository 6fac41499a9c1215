import { describe, expect, it } from 'vitest';
import type { ModuleFault } from '../ports/module-fault.ts';
import { AWAIT_TIMEOUT_MS, WATCHDOG_GRACE_MS, WATCHDOG_INTERVAL_MS } from '../sandbox-limits.ts';
import { faultFrom } from '../testing/sandbox-fixture.ts';
import type { HostBatch, HostMessage, Progress, WorkerMessage } from '../worker/protocol.ts';
import { PoolMemory } from './pool-memory.ts';
import { WorkerHost } from './worker-host.ts';
import type { PoolPlatform, WorkerListener } from './worker-link.ts';

/** A worker that does what the test says, and a watchdog that looks when the test says so. */
function fakeWorker() {
  const batches: HostBatch[] = [];
  const turns: (() => void)[] = [];
  const killed: (ModuleFault & { who: number })[] = [];
  const ended: (string | undefined)[] = [];
  let listener!: WorkerListener;
  let look: (() => void) | undefined;
  let progress: Progress = { received: 0, running: 0, sequence: 0 };
  let cpuMs = 0;
  const platform: PoolPlatform = {
    startWorker(_, given) {
      listener = given;
      return {
        post: (batch) => void batches.push(batch),
        progress: () => progress,
        setActive: () => undefined,
        terminate: () => undefined,
      };
    },
    every(_, fn) {
      look = fn;
      return () => {
        look = undefined;
      };
    },
    cpuMs: () => cpuMs,
    atEndOfTurn: (fn) => void turns.push(fn),
  };
  const host = new WorkerHost(
    'sandboxed',
    false,
    platform,
    {
      libraries: {},
      maxWorkers: 1,
      memory: { limitBytes: 1, ownerLimitBytes: 1, parts: 1 },
      hostLibraries: { echo: { say: (text) => Promise.resolve(`said ${String(text)}`) } },
    },
    new PoolMemory({ limitBytes: 1, ownerLimitBytes: 1, parts: 1 }),
    (culprit) => void ended.push(culprit?.moduleName),
  );
  let count = 0;
  return {
    host,
    batches,
    killed,
    ended,
    tell: (...messages: WorkerMessage[]) => listener.onBatch({ messages }),
    exit: (kind: 'memory' | 'exit') => listener.onExit({ kind, message: 'It is over.' }),
    endTurn: () => turns.splice(0).forEach((fn) => fn()),
    isWatched: () => look !== undefined,
    setProgress(next: Partial<Progress>) {
      progress = { ...progress, ...next };
    },
    /** Lets so much time pass for the watchdog. @param share of it in which the program computes */
    pass(ms: number, share = 1) {
      for (let i = 0; i < Math.ceil(ms / WATCHDOG_INTERVAL_MS); i++) {
        cpuMs += share * WATCHDOG_INTERVAL_MS;
        look?.();
      }
    },
    add() {
      const who = ++count;
      return host.add({
        request: {
          instanceId: `${who}`,
          moduleName: `module ${who}`,
          source: { onProcessing: '() => {}' },
          isTrusted: false,
          libraries: [],
          assets: [],
          inputs: [],
          owner: '',
          outputs: [],
          limits: { callTimeoutMs: 400, memoryBytes: 1, outputBytes: 1 },
        },
        onLog: () => undefined,
        onMemory: () => undefined,
        loadAssets: (name) => Promise.reject(new Error(name)),
        onKilled: (fault) => void killed.push({ ...fault, who }),
        onClosed: () => undefined,
      });
    },
  };
}

const CALL = { deltaTimeMs: 0, inputs: [] };
const kindsOf = (batch: HostBatch | undefined): string[] | undefined =>
  batch?.messages.map((message: HostMessage) => ('kind' in message ? message.kind : 'run'));

describe('WorkerHost', () => {
  it('sends the messages of a turn together', () => {
    const { host, add, batches, endTurn } = fakeWorker();
    const [a, b] = [add(), add()];
    void host.run(a, CALL);
    void host.run(b, CALL);
    expect(batches).toEqual([]);
    endTurn();
    expect(batches.map(kindsOf)).toEqual([['run', 'run']]);
  });

  it('ends a worker that is silent for the limit and the grace, and blames the running instance [PM-53]', async () => {
    const worker = fakeWorker();
    const [a, b] = [worker.add(), worker.add()];
    worker.tell({ kind: 'ready' });
    const runs = [worker.host.run(a, CALL), worker.host.run(b, CALL)].map(faultFrom);
    worker.endTurn();
    worker.setProgress({ received: 1, running: b, sequence: 2 });
    worker.pass(400 + WATCHDOG_GRACE_MS);
    expect(worker.killed).toEqual([]);
    worker.pass(2 * WATCHDOG_INTERVAL_MS);
    const [first, second] = await Promise.all(runs);
    expect(first).toMatchObject({ kind: 'crashed', isOfOther: true });
    expect(first?.message).toContain('"module 2"');
    expect(second).toMatchObject({ kind: 'timeout', phase: 'onProcessing' });
    expect(second?.isOfOther).toBeUndefined();
    expect(worker.killed.map(({ who, kind }) => [who, kind])).toEqual([
      [1, 'crashed'],
      [2, 'timeout'],
    ]);
    expect(worker.ended).toEqual(['module 2']);
  });

  it('gives an instance more time while the machine gives the program no CPU time, and ends it in the end [PM-53]', async () => {
    const worker = fakeWorker();
    const a = worker.add();
    worker.tell({ kind: 'ready' });
    const run = faultFrom(worker.host.run(a, CALL));
    worker.endTurn();
    worker.setProgress({ received: 1, running: a, sequence: 1 });
    worker.pass(2_000, 0.1);
    expect(worker.ended).toEqual([]);
    worker.pass(5_000, 0.1);
    expect(await run).toMatchObject({ kind: 'timeout' });
  });

  it('leaves a worker alone that gets on', () => {
    const worker = fakeWorker();
    const a = worker.add();
    worker.tell({ kind: 'ready' });
    void worker.host.run(a, CALL);
    worker.endTurn();
    for (let sequence = 1; sequence < 25; sequence++) {
      worker.setProgress({ received: 1, running: a, sequence });
      worker.pass(300);
    }
    expect(worker.ended).toEqual([]);
  });

  it('waits for a worker that is still starting', () => {
    const worker = fakeWorker();
    void worker.host.run(worker.add(), CALL);
    worker.endTurn();
    worker.pass(5_000);
    expect(worker.ended).toEqual([]);
  });

  it('kills only the instance whose promise takes too long [PM-53]', async () => {
    const worker = fakeWorker();
    const [a, b] = [worker.add(), worker.add()];
    worker.tell({ kind: 'ready' });
    const run = faultFrom(worker.host.run(a, CALL));
    worker.endTurn();
    worker.setProgress({ received: 1 });
    worker.pass(AWAIT_TIMEOUT_MS - WATCHDOG_INTERVAL_MS);
    expect(worker.killed).toEqual([]);
    worker.pass(2 * WATCHDOG_INTERVAL_MS);
    expect(await run).toMatchObject({ kind: 'timeout' });
    worker.endTurn();
    expect(kindsOf(worker.batches.at(-1))).toEqual(['free']);
    expect(worker.killed.map(({ who }) => who)).toEqual([1]);
    expect(worker.ended).toEqual([]);
    expect(b).toBe(2);
  });

  it('kills no instance when an idle worker does not respond', async () => {
    const worker = fakeWorker();
    const a = worker.add();
    worker.tell({ kind: 'ready' });
    const run = faultFrom(worker.host.run(a, CALL));
    worker.endTurn();
    worker.pass(2_000);
    expect(worker.ended).toEqual([]); // A busy machine gives it no turn.
    worker.pass(5_000);
    expect((await run).message).toContain('does not answer');
    expect(worker.ended).toEqual([undefined]);
  });

  it('blames the running instance when the worker has no memory left [PM-53]', async () => {
    const worker = fakeWorker();
    const [a, b] = [worker.add(), worker.add()];
    const runs = [worker.host.run(a, CALL), worker.host.run(b, CALL)].map(faultFrom);
    worker.setProgress({ running: a });
    worker.exit('memory');
    expect((await Promise.all(runs)).map(({ kind }) => kind)).toEqual(['memory', 'crashed']);
    expect(await faultFrom(worker.host.run(a, CALL))).toMatchObject({ kind: 'crashed' });
  });

  it('stops watching when nothing is under way', async () => {
    const worker = fakeWorker();
    const a = worker.add();
    worker.tell({ kind: 'ready' });
    const run = worker.host.halt(a);
    worker.endTurn();
    worker.tell({ kind: 'done', call: 1, fault: undefined });
    await run;
    worker.pass(WATCHDOG_INTERVAL_MS);
    expect(worker.isWatched()).toBe(false);
  });

  it('calls the libraries it offers, and nothing else [PM-52]', async () => {
    const worker = fakeWorker();
    const instance = worker.add();
    const ask = async (library: string, method: string): Promise<unknown> => {
      worker.tell({ kind: 'libraryCall', instance, request: 1, library, method, args: ['x'] });
      await new Promise((resolve) => setImmediate(resolve));
      worker.endTurn();
      return worker.batches.at(-1)?.messages.at(-1);
    };
    expect(await ask('echo', 'say')).toMatchObject({ isFulfilled: true, value: 'said x' });
    for (const [library, method] of [
      ['echo', 'constructor'],
      ['__proto__', 'toString'],
      ['nothing', 'say'],
    ] as const) {
      expect(await ask(library, method)).toMatchObject({ isFulfilled: false });
    }
  });
});
