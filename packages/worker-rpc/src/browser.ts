import { connectPeer, type Peer } from './peer.ts';

export { transfer, type Calls } from './peer.ts';

/** A web worker whose functions the page calls. */
export interface WorkerPeer<Functions> extends Pick<Peer<Functions>, 'calls'> {
  /** Ends the worker. Calls without a reply stay without one. */
  close(): void;
}

/**
 * Connects a worker that calls `serveCalls`.
 *
 * @param page functions of the page that the worker calls
 * @param failure with which all calls reject when the worker cannot start or fails outside of a call: a sentence, or what makes
 *   one of the message of the browser, which may be empty
 */
export function callWorker<Functions, Page extends object = object>(
  worker: Worker,
  page: Page,
  failure: string | ((message: string) => string),
): WorkerPeer<Functions> {
  const peer = connectPeer<Functions>(
    page,
    {
      post: (message, transfer) => worker.postMessage(message, transfer as Transferable[]),
      receive: (handle) => (worker.onmessage = ({ data }) => handle(data)),
    },
    { onError: globalThis.reportError },
  );
  worker.onerror = ({ message }) =>
    peer.close(new Error(typeof failure === 'string' ? failure : failure(message)));
  return { calls: peer.calls, close: () => worker.terminate() };
}

/** Makes functions of this worker callable. @returns the functions of the page */
export function serveCalls<Functions extends object, Page = object>(
  functions: Functions,
): Peer<Page>['calls'] {
  return connectPeer<Page>(functions, {
    post: (message, transfer) =>
      globalThis.postMessage(message, { transfer: transfer as Transferable[] }),
    receive: (handle) =>
      globalThis.addEventListener('message', ({ data }: MessageEvent) => handle(data)),
  }).calls;
}
