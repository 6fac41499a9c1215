import type { Socket } from 'node:net';

import { encodeCommand, readCommand } from './zmtp-frames.ts';

/** Bytes of the time-to-live in PING. */
const TTL_BYTES = 2;
/** Most bytes that a PING asks to have back. */
const MAX_CONTEXT_BYTES = 16;

/** With more unsent bytes than this, commands are not answered. */
const MAX_UNSENT_BYTES = 64 * 1024;

/** Returns what sends answers on a socket, unless its peer asks without taking them. */
export function answersOn(
  socket: Pick<Socket, 'write' | 'writableLength'>,
): (answer: Buffer) => void {
  return (answer) => {
    if (socket.writableLength < MAX_UNSENT_BYTES) socket.write(answer);
  };
}

/**
 * The answer to a command after the greeting: PONG to PING (ZMTP 3.1, heartbeats). It is the library of a peer that asks,
 * not the client: nothing is told about it.
 *
 * @returns undefined: the command has no answer
 * @throws ZmtpError for what is no command
 */
export function answerCommand(body: Buffer): Buffer | undefined {
  const { name, data } = readCommand(body);
  if (name !== 'PING') return undefined;
  return encodeCommand('PONG', data.subarray(TTL_BYTES, TTL_BYTES + MAX_CONTEXT_BYTES));
}
