import { crc32 } from '@foxglove/crc';

import { decompressLz4 } from '../compression/lz4-frame.ts';
import { RecordingError, RecordingLimitError } from '../records/recording-error.ts';
import { READING_LIMITS } from '../storage/reading-limits.ts';
import { parseChunk } from './chunk-content.ts';

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

/**
 * Returns the row of records in a chunk.
 *
 * @param content of the chunk record
 * @throws RecordingError when it is broken or too large [RC-43]
 */
export async function unpackChunk(content: Uint8Array): Promise<Uint8Array> {
  const head = parseChunk(content);
  const { chunkBytes } = READING_LIMITS;
  if (head.uncompressedBytes > chunkBytes) {
    throw new RecordingLimitError(
      `A chunk has ${head.uncompressedBytes} bytes when it is decompressed. At most ${chunkBytes} are read.`,
    );
  }
  const bytes = await decompress(head.compression, head.content, head.uncompressedBytes);
  if (head.uncompressedCrc !== 0 && crc32(bytes) !== head.uncompressedCrc) {
    throw new RecordingError('The checksum of a chunk is wrong.');
  }
  return bytes;
}
