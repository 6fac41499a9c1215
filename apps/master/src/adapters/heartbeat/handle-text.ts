import { readHeartbeat } from '@ubii/proto/wire';

import type { ConnectionHandle } from '../../core/ports/index.ts';

const NO_HEARTBEAT =
  'The text message is neither PING nor PONG. Send topic data as binary messages.';

/** Hands over a text from a client: a heartbeat, else a protocol error. [TD-2] [TS-2] */
export function handleText(handle: ConnectionHandle, text: string): void {
  const heartbeat = readHeartbeat(text);
  if (heartbeat === undefined) handle.handleProtocolError(NO_HEARTBEAT);
  else if (heartbeat.kind === 'pong') handle.handlePong();
  else handle.handlePing(heartbeat.timed);
}
