import { lazyPatterns } from '@ubii/patterns';
import { followPageEvents } from './browser/page-events.ts';
import type { ClientOptions } from './core/client/client-options.ts';
import type { UbiiClient } from './core/client/ubii-client.ts';
import { createClientOver } from './create-client.ts';

export { createTabIdentity } from './browser/tab-identity.ts';
export * from './exports.ts';

/**
 * A client for a page: `fetch`, the browser's WebSocket, a retry at once when the network or the page
 * comes back, and a word to the master when the page ends.
 * @throws {TypeError} if the options name no master
 */
export function createClient(options: ClientOptions): UbiiClient {
  const client = createClientOver(
    options,
    lazyPatterns(),
    (url) => new WebSocket(url),
    globalThis.location?.origin,
  );
  followPageEvents(client);
  return client;
}
