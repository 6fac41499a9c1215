import type { AttachmentIndex, ChunkIndex, MetadataIndex } from '@mcap/core';
import { PROFILE } from '../records/recording-header.ts';
import { RecordingError, RecordingLimitError } from '../records/recording-error.ts';
import { READING_LIMITS } from '../storage/reading-limits.ts';
import type { FileIndex } from './file-index.ts';

const MAGIC_BYTES = 8n;

/** A record that the index names. */
interface Place {
  readonly what: 'chunk' | 'attachment' | 'metadata';
  readonly offset: bigint;
  readonly length: bigint;
}

/**
 * Checks what an index says before anything is read by it. [RC-43]
 *
 * @param dataEnd where the data of the file ends
 * @throws RecordingError when it names bytes outside of the data or twice, or a part that no reader takes
 */
export function checkIndex(index: FileIndex, dataEnd: bigint): void {
  const places: Place[] = [
    ...index.chunks.map(placeOfChunk),
    ...index.attachments.map(placeOfAttachment),
    ...index.metadata.map(placeOfMetadata),
  ];
  places.sort((a, b) => (a.offset < b.offset ? -1 : 1));
  let free = MAGIC_BYTES;
  for (const { what, offset, length } of places) {
    if (offset < free) throw wrong(what, offset, 'overlaps with what is before it');
    free = offset + length;
    if (free > dataEnd) throw wrong(what, offset, 'ends after the data of the file');
  }
  for (const { chunkStartOffset, messageIndexOffsets } of index.chunks) {
    for (const offset of messageIndexOffsets.values()) {
      if (offset > dataEnd)
        throw wrong('chunk', chunkStartOffset, 'has an index outside of the data');
    }
  }
}

function placeOfChunk(chunk: ChunkIndex): Place {
  const { chunkStartOffset: offset, chunkLength: length, uncompressedSize } = chunk;
  const { chunkBytes, readBytes } = READING_LIMITS;
  if (uncompressedSize > BigInt(chunkBytes)) throw tooLarge('chunk', offset, chunkBytes);
  if (length > BigInt(readBytes)) throw tooLarge('chunk', offset, readBytes);
  return { what: 'chunk', offset, length };
}

function placeOfAttachment({ offset, length, dataSize }: AttachmentIndex): Place {
  if (dataSize > length) throw wrong('attachment', offset, 'is shorter than its content');
  return { what: 'attachment', offset, length };
}

function placeOfMetadata({ name, offset, length }: MetadataIndex): Place {
  const { headerBytes } = READING_LIMITS;
  if (name === PROFILE && length > BigInt(headerBytes)) {
    throw tooLarge('metadata', offset, headerBytes);
  }
  return { what: 'metadata', offset, length };
}

function wrong(what: Place['what'], offset: bigint, why: string): RecordingError {
  return new RecordingError(
    `The index of the file is wrong: the ${what} at byte ${offset} ${why}.`,
  );
}

function tooLarge(what: Place['what'], offset: bigint, maxBytes: number): RecordingLimitError {
  return new RecordingLimitError(
    `The ${what} at byte ${offset} of the file is too large. At most ${maxBytes} bytes are read.`,
  );
}
