import type { SandboxFactory } from '../ports/sandbox.ts';
import { SANDBOX_WORKER_FILES } from '../sandbox-worker-files.ts';
import type { HostLibrary, WorkerLink, WorkerListener } from '../sandbox/worker-link.ts';
import { createPooledSandboxes } from '../sandbox/worker-pool.ts';
import type { Progress, WorkerBatch, WorkerStart } from '../worker/protocol.ts';

/** Options for sandboxes in a page. */
export interface BrowserSandboxOptions {
  /** Script of workers with trusted code; default: the path of `SANDBOX_WORKER_FILES`. */
  readonly trustedWorkerUrl?: string | URL;
  /** Script of workers with sandboxed code; default: the path of `SANDBOX_WORKER_FILES`. */
  readonly sandboxWorkerUrl?: string | URL;
  /** Libraries that the page runs itself, for all code. */
  readonly hostLibraries?: Readonly<Record<string, HostLibrary>>;
  /** Workers of each kind; default: as many as cores, from 2 to 4. */
  readonly maxWorkers?: number;
  /** Memory of all sandboxed instances, bytes; default: an eighth of the machine's, 128 to 512 MiB. [PM-58] */
  readonly memoryBytes?: number;
}

const MIB = 1024 * 1024;
const MEMORY_SHARE = 1 / 8;
const MIN_MEMORY = 128 * MIB;
/** Tabs that take more are ended by phones. */
const MAX_MEMORY = 512 * MIB;

const MIN_WORKERS = 2;
const MAX_WORKERS = 4;

/**
 * Sandboxes in Web Workers. The scripts must come with their policies, see `SANDBOX_WORKER_FILES`.
 * The first worker starts with the first instance.
 */
export function createBrowserSandboxes(options: BrowserSandboxOptions = {}): SandboxFactory {
  const {
    trustedWorkerUrl = SANDBOX_WORKER_FILES.trusted.path,
    sandboxWorkerUrl = SANDBOX_WORKER_FILES.sandboxed.path,
    hostLibraries = {},
    memoryBytes = defaultMemory(),
    maxWorkers = Math.min(MAX_WORKERS, Math.max(MIN_WORKERS, navigator.hardwareConcurrency || 0)),
  } = options;
  return createPooledSandboxes(
    {
      startWorker: (start, listener) =>
        startWorker(
          start.kind === 'trusted' ? trustedWorkerUrl : sandboxWorkerUrl,
          start,
          listener,
        ),
      every(intervalMs, fn) {
        const timer = setInterval(fn, intervalMs);
        return () => clearInterval(timer);
      },
      atEndOfTurn: (fn) => queueMicrotask(fn),
    },
    {
      libraries: {},
      hostLibraries,
      maxWorkers: Math.max(1, maxWorkers),
      // Pages share no memory with workers unless they give up a lot for it: each worker has its part.
      memory: {
        limitBytes: memoryBytes,
        ownerLimitBytes: memoryBytes,
        parts: Math.max(1, maxWorkers),
      },
    },
  );
}

/** Browsers say it in gigabytes, rounded, and at most 8; some do not. */
function defaultMemory(): number {
  const { deviceMemory = 0 } = navigator as { deviceMemory?: number };
  const bytes = deviceMemory * 1024 * MIB * MEMORY_SHARE;
  return Math.min(MAX_MEMORY, Math.max(MIN_MEMORY, bytes));
}

function startWorker(url: string | URL, start: WorkerStart, listener: WorkerListener): WorkerLink {
  const worker = new Worker(url, { name: `ubii modules, ${start.kind}` });
  let progress: Progress = { received: 0, running: 0, sequence: 0 };
  let hasAnswered = false;
  worker.onmessage = ({ data }: MessageEvent<WorkerBatch>) => {
    hasAnswered = true;
    progress = data.progress ?? progress;
    listener.onBatch(data);
  };
  worker.onerror = (event) => {
    event.preventDefault();
    if (hasAnswered) return;
    const message = `The script of the worker, ${String(url)}, does not load: ${event.message || 'is it served?'}`;
    listener.onExit({ kind: 'exit', message });
  };
  worker.postMessage(start);
  return {
    post: (batch, transfer) => worker.postMessage(batch, [...transfer]),
    progress: () => progress,
    setActive: () => undefined,
    terminate() {
      worker.onmessage = null;
      worker.onerror = null;
      worker.terminate();
      listener.onGone();
    },
  };
}
