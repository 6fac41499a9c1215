import type { Engine, MaybePromise } from '../worker/engine.ts';
import { MemoryAccount } from '../worker/memory-account.ts';
import type { HostBatch, Progress, WorkerStart } from '../worker/protocol.ts';
import { WorkerLoop, type WorkerPlatform } from '../worker/worker-loop.ts';

/**
 * Globals with which a worker's code could do more than compute. The content security policy of the script forbids
 * network access; storage and channels it cannot forbid, so they are removed, and the others as a second safeguard.
 */
const REACHING = [
  'fetch',
  'fetchLater',
  'XMLHttpRequest',
  'WebSocket',
  'WebSocketStream',
  'WebTransport',
  'EventSource',
  'importScripts',
  'Request',
  'indexedDB',
  'caches',
  'cookieStore',
  'BroadcastChannel',
  'Worker',
  'SharedWorker',
  'navigator',
  'location',
  'origin',
  'Notification',
  'PushManager',
  'FontFace',
  'fonts',
  'showDirectoryPicker',
  'webkitRequestFileSystem',
  'webkitRequestFileSystemSync',
  'webkitResolveLocalFileSystemURL',
  'webkitResolveLocalFileSystemSyncURL',
  // The way to the page belongs to the worker's own program.
  'postMessage',
  'onmessage',
  'close',
  'addEventListener',
  'removeEventListener',
  'dispatchEvent',
] as const;

/**
 * Takes away, from the global object and what it inherits from, what reaches out of the worker.
 *
 * @param kept what stands in place of a global that is taken away, by name
 */
function stripGlobals(kept: Readonly<Record<string, unknown>> = {}): void {
  for (const name of REACHING) {
    for (
      let holder: object | null = globalThis;
      holder !== null;
      holder = Reflect.getPrototypeOf(holder)
    ) {
      Reflect.deleteProperty(holder, name);
    }
    Reflect.defineProperty(globalThis, name, { value: kept[name], writable: false });
  }
}

/** Globals of a dedicated worker that a page does not have. */
interface WorkerScope {
  postMessage(message: unknown, transfer: Transferable[]): void;
  addEventListener(type: string, listener: (event: never) => void): void;
}

/**
 * The program of a browser's worker; the first message tells it how to start.
 *
 * @param kept globals that stay, see `stripGlobals`
 */
export function runWorker(
  createEngine: (memory: MemoryAccount) => MaybePromise<Engine>,
  extras: Pick<WorkerPlatform, 'evaluateLibrary'> = {},
  kept: Readonly<Record<string, unknown>> = {},
): void {
  const scope = globalThis as unknown as WorkerScope;
  const post = scope.postMessage.bind(scope);
  const listen = scope.addEventListener.bind(scope);
  let starting: Promise<void> | undefined;
  let loop: WorkerLoop | undefined;

  listen('message', ({ data }: MessageEvent<WorkerStart | HostBatch>) => {
    // Loaded before the first call, whose time it must not take.
    starting ??= startLoop(data as WorkerStart, createEngine, extras, post).then((started) => {
      loop = started;
    });
    if ('kind' in data) return;
    if (loop !== undefined) loop.handleBatch(data);
    else void starting.then(() => loop?.handleBatch(data));
  });
  // A timer of one trusted module that throws is nothing to the others.
  listen('error', (event: ErrorEvent) => {
    event.preventDefault();
    loop?.handleStray(event.error);
  });
  listen('unhandledrejection', (event: PromiseRejectionEvent) => {
    event.preventDefault();
    loop?.handleStray(event.reason);
  });
  stripGlobals(kept);
}

async function startLoop(
  start: WorkerStart,
  createEngine: (memory: MemoryAccount) => MaybePromise<Engine>,
  extras: Pick<WorkerPlatform, 'evaluateLibrary'>,
  post: WorkerScope['postMessage'],
): Promise<WorkerLoop> {
  // Pages share no memory with workers unless they give up a lot for it: progress travels.
  let progress: Progress = { received: 0, running: 0, sequence: 0 };
  const turns = createTurns();
  return new WorkerLoop({
    engine: await createEngine(new MemoryAccount(start.memory)),
    hostLibraries: start.hostLibraries,
    post: (batch, transfer) => post({ ...batch, progress }, [...transfer]),
    // Its policy lets the worker load nothing.
    importLibrary: () => Promise.resolve(undefined),
    ...extras,
    noteReceived() {
      progress = { ...progress, received: progress.received + 1 };
    },
    noteRunning(running) {
      progress = { ...progress, running, sequence: progress.sequence + 1 };
      // The page must know before the code runs: afterwards may never come.
      if (running !== 0) post({ messages: [], progress }, []);
    },
    later: turns,
    nowMs: () => performance.now(),
  });
}

/** Calls functions each in a turn of its own, without the delay of timers. */
function createTurns(): (fn: () => void) => void {
  const { port1, port2 } = new MessageChannel();
  const waiting: (() => void)[] = [];
  port1.onmessage = () => waiting.shift()?.();
  return (fn) => {
    waiting.push(fn);
    port2.postMessage(undefined);
  };
}
