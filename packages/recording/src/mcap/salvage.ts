import {
  Opcode,
  McapRecordBuilder,
  McapStreamReader,
  type Attachment,
  type ChunkIndex,
  type MessageIndex,
  type TypedMcapRecord,
} from '@mcap/core';

import { RecordingError, RecordingLimitError } from '../records/recording-error.ts';
import { PROFILE } from '../records/recording-header.ts';
import { READING_LIMITS } from '../storage/reading-limits.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';
import { mcapRecordsIn, messagesIn, parseChunk } from './chunk-content.ts';
import { MAGIC_BYTES, encodeEnd, FileIndex, indexBytesOf } from './file-index.ts';
import { writeMessageIndexes } from './open-chunk.ts';
import { unpackChunk } from './unpack-chunk.ts';

/** A record of the data section of a file. */
interface StoredRecord {
  readonly opcode: number;
  /** Where it begins in the file. */
  readonly offset: bigint;
  /** The whole record, valid until the next one is asked for. */
  readonly bytes: Uint8Array;
  /** What follows opcode and length. */
  readonly content: Uint8Array;
}

const HEAD_BYTES = 9;
const WINDOW_BYTES = 4 * 1024 * 1024;

/** Reads the records of a file from its start to the end of the data, or to where the file is cut off. */
export async function* storedRecords(source: RecordingSource): AsyncGenerator<StoredRecord> {
  const size = await source.size();
  let window: Uint8Array = new Uint8Array();
  let windowAt = 0n;
  const take = async (offset: bigint, length: number): Promise<Uint8Array> => {
    const start = Number(offset - windowAt);
    if (start + length <= window.length) return window.subarray(start, start + length);
    const rest = Number(size - offset);
    window = await source.read(offset, BigInt(Math.min(Math.max(length, WINDOW_BYTES), rest)));
    windowAt = offset;
    return window.subarray(0, length);
  };
  for (let offset = MAGIC_BYTES; offset + BigInt(HEAD_BYTES) <= size;) {
    const head = await take(offset, HEAD_BYTES);
    const opcode = head[0]!;
    const length = new DataView(head.buffer, head.byteOffset).getBigUint64(1, true);
    const end = offset + BigInt(HEAD_BYTES) + length;
    if (opcode === 0 || opcode === Number(Opcode.DATA_END) || end > size) return;
    const bytes = await take(offset, HEAD_BYTES + Number(length));
    yield { opcode, offset, bytes, content: bytes.subarray(HEAD_BYTES) };
    offset = end;
  }
}

/** What is whole of a file without its end. */
export interface Salvage {
  readonly index: FileIndex;
  /** Bytes of the file that are kept. */
  readonly keptBytes: bigint;
  /** What follows them: header or message indexes of the last chunk, where they are missing; summary, footer. */
  readonly end: Uint8Array;
}

/** Bytes of a message record before its data. */
const MESSAGE_HEAD_BYTES = 31;

/** The chunk that was read last. */
interface LastChunk {
  readonly index: ChunkIndex;
  readonly end: bigint;
  readonly messages: ReadonlyMap<number, MessageIndex>;
  /** Of the schemas and channels in it. */
  readonly definitionBytes: number;
}

/** What an attachment or metadata takes in an index. */
const PART_ENTRY_BYTES = 100;

/**
 * Reads a file from its start, up to the last whole chunk, and makes the end that it lacks.
 *
 * @throws RecordingError when it does not begin with a header
 * @throws RecordingLimitError when the index would be too long, or a part is too large [RC-43]
 */
export async function salvage(source: RecordingSource): Promise<Salvage> {
  const index = new FileIndex();
  let keptBytes = MAGIC_BYTES;
  let last: LastChunk | undefined;
  let indexBytes = 0;
  for await (const record of storedRecords(source)) {
    if (keptBytes === MAGIC_BYTES) expectHeader(record);
    try {
      if (record.opcode === Number(Opcode.CHUNK)) {
        last = await takeChunk(record, index);
        const entry = indexBytesOf({ messageIndexOffsets: last.messages });
        indexBytes += entry + last.definitionBytes;
      } else if (record.opcode === Number(Opcode.MESSAGE_INDEX)) takeMessageIndex(record, last);
      else {
        indexBytes += takeRecord(record, index);
        last = undefined;
      }
      expectShort(indexBytes);
    } catch (error) {
      if (error instanceof RecordingLimitError) throw error;
      // Written by half, or never written: the disk had kept its place.
      break;
    }
    keptBytes = record.offset + BigInt(record.bytes.length);
  }
  const indexes = new McapRecordBuilder();
  if (keptBytes === MAGIC_BYTES) indexes.writeHeader({ profile: PROFILE, library: '' });
  if (last !== undefined && last.index.messageIndexOffsets.size < last.messages.size) {
    keptBytes = last.end;
    const written = writeMessageIndexes(indexes, last.messages.values(), keptBytes);
    index.chunks[index.chunks.length - 1] = { ...last.index, ...written };
  }
  const position = keptBytes + BigInt(indexes.length);
  return { index, keptBytes, end: concat(indexes.buffer, encodeEnd(index, position)) };
}

/** Without one, no reader opens the file. Where nothing was written yet, the disk has zeros. */
function expectHeader({ opcode }: StoredRecord): void {
  if (opcode === 0 || opcode === Number(Opcode.HEADER)) return;
  throw new RecordingError('The file does not begin with the header of an MCAP file.');
}

async function takeChunk(record: StoredRecord, index: FileIndex): Promise<LastChunk> {
  const head = parseChunk(record.content);
  const bytes = await unpackChunk(record.content);
  let definitionBytes = 0;
  for (const { opcode, start, end } of mcapRecordsIn(bytes)) {
    const isDefinition = opcode === Number(Opcode.SCHEMA) || opcode === Number(Opcode.CHANNEL);
    if (!isDefinition) continue;
    takeDefinition(parse(bytes.slice(start - 9, end)), index);
    definitionBytes += end - start;
    expectShort(definitionBytes);
  }
  const messages = new Map<number, MessageIndex>();
  let messageStartTime: bigint | undefined;
  let messageEndTime = 0n;
  for (const { channelId, logTimeNs, data } of messagesIn(bytes)) {
    index.count(channelId);
    const offset = BigInt(data.byteOffset - bytes.byteOffset - MESSAGE_HEAD_BYTES);
    const known = messages.get(channelId);
    if (known === undefined) messages.set(channelId, { channelId, records: [[logTimeNs, offset]] });
    else known.records.push([logTimeNs, offset]);
    if (messageStartTime === undefined || logTimeNs < messageStartTime)
      messageStartTime = logTimeNs;
    if (logTimeNs > messageEndTime) messageEndTime = logTimeNs;
  }
  const chunkLength = BigInt(record.bytes.length);
  const chunk = {
    messageStartTime: messageStartTime ?? 0n,
    messageEndTime,
    chunkStartOffset: record.offset,
    chunkLength,
    messageIndexOffsets: new Map<number, bigint>(),
    messageIndexLength: 0n,
    compression: head.compression,
    compressedSize: BigInt(head.content.length),
    uncompressedSize: BigInt(bytes.length),
  };
  index.chunks.push(chunk);
  return { index: chunk, end: record.offset + chunkLength, messages, definitionBytes };
}

function takeMessageIndex(record: StoredRecord, last: LastChunk | undefined): void {
  if (last === undefined) return;
  const { offset, bytes, content } = record;
  const channelId = new DataView(content.buffer, content.byteOffset).getUint16(0, true);
  last.index.messageIndexOffsets.set(channelId, offset);
  last.index.messageIndexLength += BigInt(bytes.length);
}

/** Returns the bytes that it takes in an index. */
function takeRecord({ offset, bytes }: StoredRecord, index: FileIndex): number {
  const length = BigInt(bytes.length);
  const parsed = parse(bytes.slice());
  if (parsed?.type === 'Header') index.profile = parsed.profile;
  else if (parsed?.type === 'Metadata') index.metadata.push({ name: parsed.name, offset, length });
  else if (parsed?.type === 'Attachment') {
    index.attachments.push({ ...attachmentHead(parsed), offset, length });
  } else {
    takeDefinition(parsed, index);
    return bytes.length;
  }
  return PART_ENTRY_BYTES;
}

function expectShort(indexBytes: number): void {
  const max = READING_LIMITS.indexBytes;
  if (indexBytes <= max) return;
  throw new RecordingLimitError(`The index of the file would have more than ${max} bytes.`);
}

function attachmentHead({ name, logTime, createTime, mediaType, data }: Attachment) {
  return { name, logTime, createTime, mediaType, dataSize: BigInt(data.length) };
}

function takeDefinition(record: TypedMcapRecord | undefined, index: FileIndex): void {
  if (record?.type === 'Schema') index.schemas.set(record.id, record);
  if (record?.type === 'Channel') index.channels.set(record.id, record);
}

/** @throws when the record is broken */
function parse(bytes: Uint8Array): TypedMcapRecord | undefined {
  const reader = new McapStreamReader({ noMagicPrefix: true });
  reader.append(bytes);
  return reader.nextRecord();
}

function concat(first: Uint8Array, second: Uint8Array): Uint8Array {
  const bytes = new Uint8Array(first.length + second.length);
  bytes.set(first);
  bytes.set(second, first.length);
  return bytes;
}
