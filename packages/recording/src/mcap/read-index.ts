import { hasMcapPrefix, McapIndexedReader } from '@mcap/core';
import { RecordingError } from '../records/recording-error.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';
import { FileIndex } from './file-index.ts';

const MAGIC_BYTES = 8n;

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

/** Reads the summary of a file; undefined when its end is missing or broken. */
export async function readIndex(source: RecordingSource): Promise<WholeFile | undefined> {
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
  index.attachments.push(...reader.attachmentIndexes);
  index.metadata.push(...reader.metadataIndexes);
  return { index, dataEnd: reader.dataEndOffset };
}
