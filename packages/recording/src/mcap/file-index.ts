import { crc32 } from '@foxglove/crc';
import {
  McapRecordBuilder,
  Opcode,
  type AttachmentIndex,
  type Channel,
  type ChunkIndex,
  type MetadataIndex,
  type Schema,
} from '@mcap/core';

import { PROFILE } from '../records/recording-header.ts';

/** Bytes of the magic at both ends of a file. */
export const MAGIC_BYTES = 8n;

/** What the summary of an MCAP file says: where everything is. */
export class FileIndex {
  /** Profile in the header of the file. */
  profile = PROFILE;
  readonly schemas = new Map<number, Schema>();
  readonly channels = new Map<number, Channel>();
  readonly chunks: ChunkIndex[] = [];
  readonly attachments: AttachmentIndex[] = [];
  readonly metadata: MetadataIndex[] = [];
  /** By channel id. */
  readonly messages = new Map<number, bigint>();

  /** Counts a message. */
  count(channelId: number): void {
    this.messages.set(channelId, (this.messages.get(channelId) ?? 0n) + 1n);
  }

  /** Number of all messages. */
  get messageCount(): bigint {
    return [...this.messages.values()].reduce((sum, count) => sum + count, 0n);
  }

  /** First and last log time of all messages; both 0 without messages. */
  get times(): { startNs: bigint; endNs: bigint } {
    return timesOf(this.chunks);
  }
}

/** Bytes that a chunk takes in the summary, about. */
export function indexBytesOf({
  messageIndexOffsets,
}: {
  readonly messageIndexOffsets: { readonly size: number };
}): number {
  return 100 + 10 * messageIndexOffsets.size;
}

/** First and last log time in chunks; both 0 without chunks. */
export function timesOf(chunks: readonly ChunkIndex[]): { startNs: bigint; endNs: bigint } {
  let startNs = chunks[0]?.messageStartTime ?? 0n;
  let endNs = 0n;
  for (const { messageStartTime, messageEndTime } of chunks) {
    if (messageStartTime < startNs) startNs = messageStartTime;
    if (messageEndTime > endNs) endNs = messageEndTime;
  }
  return { startNs, endNs };
}

/**
 * Encodes all that follows the data of a file: end of data, summary, footer.
 *
 * @param position where it begins in the file
 */
export function encodeEnd(index: FileIndex, position: bigint): Uint8Array {
  const builder = new McapRecordBuilder();
  // 0: the data has no checksum of its own, as each chunk has one.
  builder.writeDataEnd({ dataSectionCrc: 0 });
  const summaryAt = builder.length;
  const at = (): bigint => position + BigInt(builder.length);
  const groups: { groupOpcode: number; groupStart: bigint; groupLength: bigint }[] = [];
  for (const [groupOpcode, write] of summaryGroups(index, builder)) {
    const groupStart = at();
    write();
    const groupLength = at() - groupStart;
    if (groupLength > 0n) groups.push({ groupOpcode, groupStart, groupLength });
  }
  const summaryOffsetStart = at();
  for (const group of groups) builder.writeSummaryOffset(group);
  const summaryStart = position + BigInt(summaryAt);
  builder.writeFooter({ summaryStart, summaryOffsetStart, summaryCrc: 0 });
  const crcAt = builder.length - 4;
  builder.writeMagic();
  const bytes = builder.buffer;
  // The checksum is of the summary and of the footer before it.
  new DataView(bytes.buffer).setUint32(crcAt, crc32(bytes.subarray(summaryAt, crcAt)), true);
  return bytes;
}

function summaryGroups(
  index: FileIndex,
  builder: McapRecordBuilder,
): [opcode: number, write: () => void][] {
  const { schemas, channels, chunks, attachments, metadata } = index;
  return [
    [Opcode.SCHEMA, () => schemas.forEach((schema) => builder.writeSchema(schema))],
    [Opcode.CHANNEL, () => channels.forEach((channel) => builder.writeChannel(channel))],
    [Opcode.STATISTICS, () => writeStatistics(index, builder)],
    [Opcode.METADATA_INDEX, () => metadata.forEach((entry) => builder.writeMetadataIndex(entry))],
    [
      Opcode.ATTACHMENT_INDEX,
      () => attachments.forEach((entry) => builder.writeAttachmentIndex(entry)),
    ],
    [Opcode.CHUNK_INDEX, () => chunks.forEach((entry) => builder.writeChunkIndex(entry))],
  ];
}

function writeStatistics(index: FileIndex, builder: McapRecordBuilder): void {
  const { startNs, endNs } = index.times;
  builder.writeStatistics({
    messageCount: index.messageCount,
    schemaCount: index.schemas.size,
    channelCount: index.channels.size,
    attachmentCount: index.attachments.length,
    metadataCount: index.metadata.length,
    chunkCount: index.chunks.length,
    messageStartTime: startNs,
    messageEndTime: endNs,
    channelMessageCounts: index.messages,
  });
}

/** Name of the attachments that hold the last value of each channel, as a row of MCAP message records. */
export const SNAPSHOT_NAME = 'ubi-interact/last-values';
/** Their media type. */
export const SNAPSHOT_TYPE = 'application/x-ubi-interact.last-values';
