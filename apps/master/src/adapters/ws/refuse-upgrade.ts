import { STATUS_CODES } from 'node:http';
import type { Duplex } from 'node:stream';
import type { Clock } from '@ubii/timing';

/** Time for the client to read the response and close, milliseconds. */
const LINGER_MS = 1_000;

/**
 * Answers an upgrade request with an ordinary HTTP response and closes, whatever the other side does.
 * Further data from the client is discarded: a connection that is closed while bytes wait on it is reset, and
 * the answer may be lost. [AC-65]
 */
export function refuseUpgrade(
  socket: Duplex,
  status: number,
  reason: string,
  clock: Pick<Clock, 'after'>,
): void {
  const body = Buffer.from(`${reason}\n`);
  const head = [
    `HTTP/1.1 ${status} ${STATUS_CODES[status]}`,
    'Connection: close',
    'Content-Type: text/plain; charset=utf-8',
    `Content-Length: ${body.length}`,
    '',
    '',
  ].join('\r\n');
  const end = (): void => void socket.destroy();
  const cancel = clock.after(LINGER_MS, end);
  socket.on('error', end).on('end', end).on('close', cancel);
  socket.resume();
  socket.end(Buffer.concat([Buffer.from(head, 'latin1'), body]));
}
