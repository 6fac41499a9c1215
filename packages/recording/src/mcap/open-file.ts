import {
  hasMcapPrefix,
  McapIndexedReader,
  Opcode,
  type AttachmentIndex,
  type ChunkIndex,
  type MetadataIndex,
} from '@mcap/core';

import { RecordingError, RecordingLimitError } from '../records/recording-error.ts';
import { PROFILE } from '../records/recording-header.ts';
import { READING_LIMITS } from '../storage/reading-limits.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';
import { MAGIC_BYTES, FileIndex } from './file-index.ts';
import { salvage } from './salvage.ts';

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
function checkIndex(index: FileIndex, dataEnd: bigint): void {
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

/** Footer record and magic. */
const FOOTER_BYTES = 37n;
const SUMMARY_START_AT = 9;

/** The index of a file that is whole. */
interface WholeFile {
  readonly index: FileIndex;
  /** Where the data ends and the summary begins. */
  readonly dataEnd: bigint;
}

/** @throws RecordingError when the source does not begin as an MCAP file */
export async function expectMcap(source: RecordingSource): Promise<void> {
  const isLongEnough = (await source.size()) >= MAGIC_BYTES;
  const start = isLongEnough ? await source.read(0n, MAGIC_BYTES) : new Uint8Array();
  if (!hasMcapPrefix(new DataView(start.buffer, start.byteOffset, start.byteLength))) {
    throw new RecordingError('The file is not an MCAP file.');
  }
}

/** Bytes of the index, as the footer says; 0 when the end of the file is missing or broken. */
export async function indexBytesOf(source: RecordingSource): Promise<bigint> {
  const size = await source.size();
  if (size <= FOOTER_BYTES) return 0n;
  const footer = await source.read(size - FOOTER_BYTES, FOOTER_BYTES);
  const view = new DataView(footer.buffer, footer.byteOffset, footer.byteLength);
  const magic = new DataView(footer.buffer, footer.byteOffset + Number(FOOTER_BYTES - MAGIC_BYTES));
  if (view.getUint8(0) !== Number(Opcode.FOOTER) || !hasMcapPrefix(magic)) return 0n;
  const summaryStart = view.getBigUint64(SUMMARY_START_AT, true);
  return summaryStart > 0n && summaryStart < size ? size - summaryStart : 0n;
}

/**
 * Reads the summary of a file.
 *
 * @returns undefined when its end is missing or broken
 * @throws RecordingError when it is too long, or names what is not in the file [RC-43]
 */
export async function readIndex(source: RecordingSource): Promise<WholeFile | undefined> {
  const { indexBytes } = READING_LIMITS;
  if ((await indexBytesOf(source)) > indexBytes) {
    throw new RecordingLimitError(
      `The index of the file is too long. At most ${indexBytes} bytes are read.`,
    );
  }
  let reader: McapIndexedReader;
  try {
    reader = await McapIndexedReader.Initialize({ readable: source });
  } catch {
    return undefined;
  }
  const index = new FileIndex();
  index.profile = reader.header.profile;
  for (const [id, schema] of reader.schemasById) index.schemas.set(id, schema);
  for (const [id, channel] of reader.channelsById) index.channels.set(id, channel);
  for (const [id, count] of reader.statistics?.channelMessageCounts ?? []) {
    index.messages.set(id, count);
  }
  for (const chunk of reader.chunkIndexes) index.chunks.push(chunk);
  for (const attachment of reader.attachmentIndexes) index.attachments.push(attachment);
  for (const metadata of reader.metadataIndexes) index.metadata.push(metadata);
  checkIndex(index, reader.dataEndOffset);
  return { index, dataEnd: reader.dataEndOffset };
}

/** A file that can be read by its index. */
export interface OpenFile {
  readonly index: FileIndex;
  readonly source: RecordingSource;
  /** The end of the file is missing, and was rebuilt in memory. */
  readonly isDamaged: boolean;
}

/** Opens a file by its index, which is rebuilt when the file has none. @throws RecordingError when it is no MCAP file */
export async function openFile(source: RecordingSource): Promise<OpenFile> {
  await expectMcap(source);
  const whole = await readIndex(source);
  if (whole !== undefined) return { index: whole.index, source, isDamaged: false };
  return { index: (await salvage(source)).index, source, isDamaged: true };
}
