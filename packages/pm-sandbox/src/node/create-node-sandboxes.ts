import { availableParallelism } from 'node:os';
import { Worker } from 'node:worker_threads';
import type { SandboxFactory } from '../ports/sandbox.ts';
import { SANDBOXED_HEAP_BYTES, TRUSTED_HEAP_BYTES } from '../sandbox-limits.ts';
import type { HostLibrary, WorkerLink, WorkerListener } from '../sandbox/worker-link.ts';
import { createPooledSandboxes } from '../sandbox/worker-pool.ts';
import type { WorkerBatch, WorkerStart } from '../worker/protocol.ts';
import type { NodeWorkerData } from './node-worker.ts';
import { defaultModuleMemory, defaultSessionMemory } from './default-memory.ts';
import { processCpuMs } from './process-cpu.ts';
import { createProgressMemory, readProgress } from './shared-progress.ts';

/** Options for sandboxes in Node.js. */
export interface NodeSandboxOptions {
  /** The worker, as `buildNodeWorker` of `@ubii/pm-sandbox/build` writes it. */
  readonly workerFile: URL | string;
  /**
   * Libraries of trusted code by name: specifiers that the worker imports, absolute or of packages
   * beside the worker file. A module gets its default export or, without one, all of it.
   */
  readonly libraries?: Readonly<Record<string, string>>;
  /** Libraries that this program runs itself, for sandboxed code as well. */
  readonly hostLibraries?: Readonly<Record<string, HostLibrary>>;
  /** Workers of each kind, trusted and sandboxed; default: as many as cores, at least 2. */
  readonly maxWorkers?: number;
  /** Memory of all sandboxed instances, bytes; default: `defaultModuleMemory`. [PM-58] */
  readonly memoryBytes?: number;
  /** Memory of the sandboxed instances of one session, bytes; default: half of `memoryBytes`, 1 GiB at most. */
  readonly ownerMemoryBytes?: number;
}

/** Least workers of a kind: one that is held up must not hold up all. */
const MIN_WORKERS = 2;
const MIB = 1024 * 1024;
/** See STACK_BYTES in node-worker.ts. */
const THREAD_STACK_MB = 16;

/** Sandboxes on threads of this process. The first thread starts with the first instance. */
export function createNodeSandboxes(options: NodeSandboxOptions): SandboxFactory {
  const { workerFile, libraries = {}, hostLibraries = {} } = options;
  const { memoryBytes = defaultModuleMemory() } = options;
  const maxWorkers = Math.max(
    1,
    options.maxWorkers ?? Math.max(MIN_WORKERS, availableParallelism()),
  );
  return createPooledSandboxes(
    {
      startWorker: (start, listener) => startWorker(workerFile, start, listener),
      every(intervalMs, fn) {
        const timer = setInterval(fn, intervalMs);
        return () => clearInterval(timer);
      },
      cpuMs: processCpuMs,
      atEndOfTurn: (fn) => queueMicrotask(fn),
    },
    {
      libraries,
      hostLibraries,
      maxWorkers,
      memory: {
        limitBytes: memoryBytes,
        ownerLimitBytes: options.ownerMemoryBytes ?? defaultSessionMemory(memoryBytes),
        parts: undefined,
      },
    },
  );
}

function startWorker(
  workerFile: URL | string,
  start: WorkerStart,
  listener: WorkerListener,
): WorkerLink {
  const progress = createProgressMemory();
  const data: NodeWorkerData = { start, progress };
  const heapBytes = start.kind === 'trusted' ? TRUSTED_HEAP_BYTES : SANDBOXED_HEAP_BYTES;
  const worker = new Worker(workerFile, {
    name: `ubii modules, ${start.kind}`,
    workerData: data,
    env: {},
    argv: [],
    execArgv: [],
    stdin: false,
    // Discards output of trusted code that bypasses its console. Not read either: a stream that is read keeps the
    // program alive.
    stdout: true,
    stderr: true,
    resourceLimits: { maxOldGenerationSizeMb: heapBytes / MIB, stackSizeMb: THREAD_STACK_MB },
  });
  let isOver = false;
  const over = (kind: 'memory' | 'exit', message: string): void => {
    if (isOver) return;
    isOver = true;
    listener.onExit({ kind, message });
  };
  worker.on('message', (batch: WorkerBatch) => {
    if (!isOver) listener.onBatch(batch);
  });
  worker.on('error', (error: Error & { code?: string }) => {
    if (error.code === 'ERR_WORKER_OUT_OF_MEMORY') over('memory', error.message);
    else over('exit', `The worker failed: ${error.message}.`);
  });
  worker.on('exit', (code) => {
    listener.onGone();
    over('exit', `The worker exited unexpectedly with code ${code}.`);
  });
  worker.unref();
  return {
    post: (batch, transfer) => worker.postMessage(batch, transfer),
    progress: () => readProgress(progress),
    setActive(isActive) {
      if (isActive) worker.ref();
      else worker.unref();
    },
    terminate() {
      isOver = true;
      void worker.terminate();
    },
  };
}
