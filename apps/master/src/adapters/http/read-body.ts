import type { Readable } from 'node:stream';
import { ServiceError } from '@ubii/proto';

/** A body that is larger than allowed is read on up to this many times the limit, so that its sender hears the answer. */
const DISCARD_FACTOR = 2;

/**
 * Reads a request's body.
 *
 * @returns the bytes; undefined when there are more than `maxBytes`
 * @throws ServiceError when the sender breaks off
 */
export function readBody(stream: Readable, maxBytes: number): Promise<Buffer | undefined> {
  return new Promise((resolve, reject) => {
    let chunks: Buffer[] = [];
    let size = 0;
    stream.on('data', (chunk: Buffer) => {
      size += chunk.length;
      if (size <= maxBytes) {
        chunks.push(chunk);
        return;
      }
      chunks = [];
      if (size > DISCARD_FACTOR * maxBytes) {
        stream.pause();
        resolve(undefined);
      }
    });
    stream.on('end', () => {
      const [only] = chunks;
      if (size > maxBytes) resolve(undefined);
      else resolve(chunks.length === 1 && only ? only : Buffer.concat(chunks, size));
    });
    const breakOff = (): void =>
      reject(new ServiceError('invalid_argument', 'The request broke off before its end.'));
    stream.on('error', breakOff);
    stream.on('close', breakOff);
  });
}
