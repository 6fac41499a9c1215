import { Opcode, type ChunkIndex } from '@mcap/core';
import { RecordingError, RecordingLimitError } from '../records/recording-error.ts';
import { READING_LIMITS } from '../storage/reading-limits.ts';

/** A message in decompressed bytes. */
export interface StoredMessage {
  readonly channelId: number;
  /** Place among all messages of the file, in files of ours. */
  readonly sequence: number;
  readonly logTimeNs: bigint;
  readonly publishTimeNs: bigint;
  readonly data: Uint8Array;
}

const RECORD_HEAD_BYTES = 9;
const MESSAGE_HEAD_BYTES = 22;

/** A record of MCAP in bytes: what it is, and where its content is. */
export interface McapRecord {
  readonly opcode: number;
  /** First byte of the content. */
  readonly start: number;
  readonly end: number;
}

/** Reads the row of MCAP records in bytes. @throws RecordingError when the last one is cut off */
export function* mcapRecordsIn(bytes: Uint8Array): Generator<McapRecord> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let pos = 0; pos < bytes.length;) {
    const start = pos + RECORD_HEAD_BYTES;
    const end = start <= bytes.length ? start + Number(view.getBigUint64(pos + 1, true)) : Infinity;
    if (end > bytes.length) throw new RecordingError('A chunk is cut off in its last record.');
    yield { opcode: bytes[pos]!, start, end };
    pos = end;
  }
}

/**
 * The messages in a chunk or snapshot, in the order of the file. Their data are views of the bytes.
 *
 * @throws RecordingError when one is cut off, or there are too many [RC-43]
 */
export function messagesIn(bytes: Uint8Array): StoredMessage[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const { chunkMessages } = READING_LIMITS;
  const messages: StoredMessage[] = [];
  for (const { opcode, start, end } of mcapRecordsIn(bytes)) {
    if (opcode !== Number(Opcode.MESSAGE)) continue;
    if (end - start < MESSAGE_HEAD_BYTES) throw new RecordingError('A message is cut off.');
    if (messages.length >= chunkMessages)
      throw new RecordingLimitError(`A chunk has more than ${chunkMessages} messages.`);
    messages.push({
      channelId: view.getUint16(start, true),
      sequence: view.getUint32(start + 2, true),
      logTimeNs: view.getBigUint64(start + 6, true),
      publishTimeNs: view.getBigUint64(start + 14, true),
      data: bytes.subarray(start + MESSAGE_HEAD_BYTES, end),
    });
  }
  return messages;
}

/** Compares messages by log time. */
export function byTime(a: StoredMessage, b: StoredMessage): number {
  if (a.logTimeNs === b.logTimeNs) return 0;
  return a.logTimeNs < b.logTimeNs ? -1 : 1;
}

/** A chunk record, before it is decompressed. */
export interface ChunkHead {
  readonly compression: string;
  readonly uncompressedBytes: number;
  /** 0 when the writer made none. */
  readonly uncompressedCrc: number;
  readonly content: Uint8Array;
}

/** Opcode, length, times and size before compression. */
const CHUNK_HEAD_BYTES = 33;

/**
 * Checks that the index names a chunk where there is one.
 *
 * @param head the first `CHUNK_HEAD_BYTES` of the record, or more
 * @throws RecordingError when the index is wrong
 */
export function expectChunk(
  head: Uint8Array,
  { chunkLength, uncompressedSize }: Pick<ChunkIndex, 'chunkLength' | 'uncompressedSize'>,
): void {
  const view = new DataView(head.buffer, head.byteOffset, head.byteLength);
  const isChunk =
    head.length >= CHUNK_HEAD_BYTES &&
    view.getUint8(0) === Number(Opcode.CHUNK) &&
    view.getBigUint64(1, true) === chunkLength - BigInt(RECORD_HEAD_BYTES) &&
    view.getBigUint64(25, true) === uncompressedSize;
  if (isChunk) return;
  throw new RecordingError('The index of the file is wrong: it names a chunk where there is none.');
}

/** Reads the content of a chunk record. @throws RecordingError when it is cut off */
export function parseChunk(content: Uint8Array): ChunkHead {
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  try {
    const textBytes = view.getUint32(28, true);
    const bytesAt = 32 + textBytes + 8;
    const bytes = Number(view.getBigUint64(bytesAt - 8, true));
    if (bytesAt + bytes > content.length) throw new RangeError('Less content than stated.');
    return {
      uncompressedBytes: Number(view.getBigUint64(16, true)),
      uncompressedCrc: view.getUint32(24, true),
      compression: new TextDecoder().decode(content.subarray(32, 32 + textBytes)),
      content: content.subarray(bytesAt, bytesAt + bytes),
    };
  } catch (cause) {
    throw new RecordingError('A chunk is cut off.', { cause });
  }
}
