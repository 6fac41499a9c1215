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
export function stripGlobals(kept: Readonly<Record<string, unknown>> = {}): void {
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
