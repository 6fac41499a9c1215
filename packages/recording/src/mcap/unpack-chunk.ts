import { crc32 } from '@foxglove/crc';
import { decompress } from '../compression/decompress.ts';
import { RecordingError, RecordingLimitError } from '../records/recording-error.ts';
import { READING_LIMITS } from '../storage/reading-limits.ts';
import { parseChunk } from './chunk-content.ts';

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
