import { readyPatterns } from '@ubii/patterns';
import { Re2Patterns } from '@ubii/patterns/re2';
import { WebSocket } from 'ws';
import type { ClientOptions } from './core/client/client-options.ts';
import type { UbiiClient } from './core/client/ubii-client.ts';
import { createClientOver } from './create-client.ts';

/**
 * A client for Node 20 and later: the global `fetch` and the WebSocket of the ws package.
 * @throws {TypeError} if the options name no master
 */
export function createClient(options: ClientOptions): UbiiClient {
  // Compression is off: small records only grow, and the master takes none. [TD-1]
  return createClientOver(
    options,
    readyPatterns(new Re2Patterns()),
    (url) => new WebSocket(url, { perMessageDeflate: false }),
    undefined,
  );
}
