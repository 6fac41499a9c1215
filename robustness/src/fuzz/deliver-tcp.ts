import { connect } from 'node:net';

/** Past this the master holds a connection that its peer has given up. A limit on waiting, not a measure. */
const TIMEOUT_MS = 30_000;
const MAX_KEPT_BYTES = 64 * 1024;

/**
 * Sends bytes, then says that no more come, and waits until the master has hung up.
 *
 * @returns the beginning of what it answered
 * @throws Error when it does not hang up
 */
export function sendAndWaitForEnd(
  port: number,
  input: Uint8Array,
  endsAfterAnswer = false,
): Promise<Buffer> {
  return new Promise((resolve, reject) => {
    const chunks: Buffer[] = [];
    let size = 0;
    const socket = connect(port, '127.0.0.1');
    const timer = setTimeout(() => {
      socket.destroy();
      reject(new Error('The master neither answered nor closed a connection that its peer ended.'));
    }, TIMEOUT_MS);
    socket.on('connect', () => (endsAfterAnswer ? socket.write(input) : socket.end(input)));
    socket.on('data', (chunk: Buffer) => {
      if (size === 0 && endsAfterAnswer) socket.end();
      if (size < MAX_KEPT_BYTES) chunks.push(chunk);
      size += chunk.length;
    });
    // A reset is a way to hang up; `close` follows.
    socket.on('error', () => {});
    socket.on('close', () => {
      clearTimeout(timer);
      resolve(Buffer.concat(chunks));
    });
  });
}

/** @throws Error when an HTTP server answered with an error of its own making */
export function requireNoServerError(answer: Buffer): void {
  const head = answer.toString('latin1', 0, 200);
  const status = /^HTTP\/1\.[01] (\d{3})/.exec(head)?.[1];
  if (status === '500' || status === '502') throw new Error(`The master answered ${head}`);
  const text = answer.toString('latin1');
  if (/"code":\s*"internal"/.test(text))
    throw new Error(`The master answered ${text.slice(0, 800)}`);
}
