import { RecordingError } from '../records/recording-error.ts';
import { decompressLz4 } from './lz4-frame.ts';

/**
 * Decompresses a chunk.
 *
 * @param compression as MCAP names it: empty, `lz4` or `zstd`, whose code is loaded when it is needed first
 * @param bytes of the content
 * @throws RecordingError when the compression is another or the content broken
 */
export async function decompress(
  compression: string,
  content: Uint8Array,
  bytes: number,
): Promise<Uint8Array> {
  try {
    if (compression === '') return expectSize(content, bytes);
    if (compression === 'lz4') return decompressLz4(content, bytes);
    if (compression === 'zstd') {
      const zstd = await import('fzstd');
      return zstd.decompress(content, new Uint8Array(bytes));
    }
  } catch (cause) {
    throw new RecordingError(`A chunk cannot be decompressed (${compression}).`, { cause });
  }
  throw new RecordingError(`Chunks compressed by "${compression}" cannot be read.`);
}

function expectSize(content: Uint8Array, bytes: number): Uint8Array {
  if (content.length === bytes) return content;
  throw new RangeError(`The chunk has ${content.length} bytes, ${bytes} are stated.`);
}
