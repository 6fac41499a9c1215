import { parentPort, Worker, type Transferable } from 'node:worker_threads';
import { connectPeer, type Calls, type Peer, type PeerOptions } from './peer.ts';

export { transfer, type Calls } from './peer.ts';

/** A thread to open. */
export interface ThreadOptions {
  readonly workerFile: URL;
  readonly name: string;
  readonly workerData: unknown;
  /** Memory and ports in `workerData` that the thread takes over. */
  readonly transferList?: readonly Transferable[];
  readonly heapMib: number;
  /**
   * Is called once, when the thread ends by itself: it could not start, failed, or took too much memory.
   *
   * @param reason part of a sentence
   */
  onEnd(reason: string): void;
  /** Makes the error of calls that have no reply when the thread ends. @param reason part of a sentence */
  lost(reason: string): Error;
}

/** A thread whose functions this one calls. */
export interface Thread<Functions> {
  readonly calls: Calls<Functions>;
  /** Keeps the process alive from now on. */
  ref(): void;
  /** Ends it. `onEnd` is not called. */
  end(reason: string): Promise<void>;
}

/**
 * Opens a thread that calls `serveThread`. It keeps no process alive, and has no environment and arguments of the program.
 *
 * @param functions what the thread calls of this one
 */
export function openThread<Functions, Own extends object = object>(
  options: ThreadOptions,
  functions: Own,
): Thread<Functions> {
  const worker = startWorker(options, (error) => queueMicrotask(() => handleEnd(String(error))));
  const peer = connectPeer<Functions>(functions, {
    post: (message, transfer) => worker?.postMessage(message, transfer as Transferable[]),
    receive: (handle) => void worker?.on('message', handle),
  });
  let isEnded = false;
  const end = async (reason: string): Promise<void> => {
    isEnded = true;
    peer.close(options.lost(reason));
    await worker?.terminate();
  };
  function handleEnd(reason: string): void {
    if (isEnded) return;
    void end(reason);
    options.onEnd(reason);
  }
  worker?.on('error', (error) => handleEnd(error.message));
  worker?.on('exit', () => handleEnd('its thread ended'));
  worker?.unref();
  return { calls: peer.calls, ref: () => worker?.ref(), end };
}

/** @returns undefined when the system has no thread left */
function startWorker(
  { workerFile, name, workerData, transferList, heapMib }: ThreadOptions,
  onError: (error: unknown) => void,
): Worker | undefined {
  try {
    return new Worker(workerFile, {
      name,
      workerData,
      ...(transferList && { transferList: [...transferList] }),
      env: {},
      argv: [],
      execArgv: [],
      resourceLimits: { maxOldGenerationSizeMb: heapMib },
    });
  } catch (error) {
    onError(error);
    return undefined;
  }
}

/** Makes functions of this thread callable. @returns the functions of the other one */
export function serveThread<Functions extends object, Other = object>(
  functions: Functions,
  options?: Pick<PeerOptions, 'asError'>,
): Peer<Other>['calls'] {
  const port = parentPort!;
  return connectPeer<Other>(
    functions,
    {
      post: (message, transfer) => port.postMessage(message, transfer as Transferable[]),
      receive: (handle) => void port.on('message', handle),
    },
    options,
  ).calls;
}
