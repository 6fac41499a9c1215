import { hasMcapPrefix, McapIndexedReader, Opcode } from '@mcap/core';
import { RecordingError, RecordingLimitError } from '../records/recording-error.ts';
import { READING_LIMITS } from '../storage/reading-limits.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';
import { checkIndex } from './check-index.ts';
import { FileIndex } from './file-index.ts';

const MAGIC_BYTES = 8n;
/** Footer record and magic. */
const FOOTER_BYTES = 37n;
const SUMMARY_START_AT = 9;

/** The index of a file that is whole. */
export interface WholeFile {
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
