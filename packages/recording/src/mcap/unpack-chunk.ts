import { crc32 } from '@foxglove/crc';
import { decompress } from '../compression/decompress.ts';
import { RecordingError } from '../records/recording-error.ts';
import { parseChunk } from './chunk-content.ts';

/**
 * Returns the row of records in a chunk.
 *
 * @param content of the chunk record
 * @throws RecordingError when it is broken
 */
export async function unpackChunk(content: Uint8Array): Promise<Uint8Array> {
  const head = parseChunk(content);
  const bytes = await decompress(head.compression, head.content, head.uncompressedBytes);
  if (head.uncompressedCrc !== 0 && crc32(bytes) !== head.uncompressedCrc) {
    throw new RecordingError('The checksum of a chunk is wrong.');
  }
  return bytes;
}
