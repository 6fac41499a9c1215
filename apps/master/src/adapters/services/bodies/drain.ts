import type { Readable } from 'node:stream';
import type { Clock } from '@ubii/timing';

/** Most bytes of a refused body that are still read, so that its sender receives the reply. */
const MAX_DRAINED_BYTES = 1024 * 1024;
/** For how long. */
const DRAIN_DEADLINE_MS = 2_000;

/** What a body is read from. A message of HTTP says when the body is complete. */
type Source = Readable & { readonly complete?: boolean };

/**
 * Throws away what still comes of a refused body. A connection that is closed while bytes wait on it
 * is reset, and its peer may lose the answer. [SV-45]
 *
 * @returns resolves when the body ended, or when that took too long or was too much
 */
export function drain(stream: Source, clock: Clock): Promise<void> {
  if (stream.complete === true || stream.destroyed) return Promise.resolve();
  return new Promise((resolve) => {
    let size = 0;
    const end = (): void => {
      cancel();
      stream.off('data', count);
      stream.pause();
      resolve();
    };
    const count = (chunk: Buffer): void => {
      size += chunk.length;
      if (size > MAX_DRAINED_BYTES) end();
    };
    const cancel = clock.after(DRAIN_DEADLINE_MS, end);
    stream.on('data', count).once('end', end).once('close', end).on('error', end);
    stream.resume();
  });
}
