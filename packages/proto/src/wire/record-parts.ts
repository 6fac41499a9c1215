import { MalformedError } from '../binary/malformed-error.ts';
import { readText } from '../binary/read-text.ts';
import { Reader } from '../binary/reader.ts';
import type { TextCache } from '../binary/text-cache.ts';
import { varintSize, writeVarint } from '../binary/varint.ts';
import { writeMessage } from '../binary/write-message.ts';
import type { Writer } from '../binary/writer.ts';
import type { ClusterRecords } from '../generated/messages.ts';
import {
  PART_NUMBER_TAG,
  PART_RECORDS_TAG,
  PART_STREAM_TAG,
  PART_TAG,
  TOLD_PUBLISHERS_TAG,
  TOLD_PUBLISHER_ID_TAG,
  TOLD_RECORD_TAG,
  TOLD_STAMPS_TAG,
} from './tags.ts';

/** Records for other masters, encoded as far as it is the same for all of them. */
export interface RecordsForMasters {
  readonly records: readonly Uint8Array[];
  /** The other members of `ClusterRecords`. */
  readonly others: Uint8Array;
  /** Bytes of `ClusterRecords`. */
  readonly byteLength: number;
}

/** A part of a stream between masters that has records and nothing else. */
export interface RecordPart {
  readonly stream: number;
  readonly number: number;
  readonly records: ClusterRecords;
}

/** Prepares records to be sent to any number of masters. @param told borrowed until the last one is encoded */
export function prepareRecordsForMasters(told: ClusterRecords): RecordsForMasters {
  const others = writeMessage(writeOthers, told);
  let byteLength = others.byteLength;
  for (const { length } of told.records) byteLength += memberSize(length);
  return { records: told.records, others, byteLength };
}

/** Encodes a `ClusterMessage` with a part that has these records. Each is copied once. */
export function encodeRecordPart(
  stream: number,
  number: number,
  { records, others, byteLength }: RecordsForMasters,
): Uint8Array {
  const partSize = 2 + varintSize(stream) + varintSize(number) + memberSize(byteLength);
  const message = new Uint8Array(memberSize(partSize));
  let pos = writeHead(message, 0, PART_TAG, partSize);
  pos = writeHead(message, pos, PART_STREAM_TAG, stream);
  pos = writeHead(message, pos, PART_NUMBER_TAG, number);
  pos = writeHead(message, pos, PART_RECORDS_TAG, byteLength);
  for (const record of records) {
    pos = writeHead(message, pos, TOLD_RECORD_TAG, record.length);
    message.set(record, pos);
    pos += record.length;
  }
  message.set(others, pos);
  return message;
}

/**
 * Reads a `ClusterMessage` with a part that has records and nothing else.
 *
 * @param message borrowed: the records are views of it
 * @param texts remembers ids of publishers
 * @returns undefined for every other message, also one that cannot be read: `decode` is for those
 */
export function readRecordPart(message: Uint8Array, texts: TextCache): RecordPart | undefined {
  if (message[0] !== PART_TAG) return undefined;
  try {
    return readPart(new Reader(message), texts);
  } catch (cause) {
    if (cause instanceof MalformedError) return undefined;
    throw cause;
  }
}

function readPart(reader: Reader, texts: TextCache): RecordPart | undefined {
  reader.tag();
  const messageEnd = reader.enter();
  if (reader.end !== messageEnd) return undefined;
  let stream = 0;
  let number = 0;
  let records: ClusterRecords | undefined = undefined;
  while (reader.pos < reader.end) {
    const tag = reader.tag();
    if (tag === PART_STREAM_TAG) stream = reader.int32();
    else if (tag === PART_NUMBER_TAG) number = reader.int32();
    else if (tag !== PART_RECORDS_TAG || records !== undefined) return undefined;
    else if ((records = readRecords(reader, texts)) === undefined) return undefined;
  }
  return records && { stream, number, records };
}

function readRecords(reader: Reader, texts: TextCache): ClusterRecords | undefined {
  const told: ClusterRecords = { records: [], stamps: [], publishers: [], publisherIds: [] };
  const outerEnd = reader.enter();
  while (reader.pos < reader.end) {
    const tag = reader.tag();
    if (tag === TOLD_RECORD_TAG) told.records.push(reader.bytes());
    else if (tag === TOLD_STAMPS_TAG) reader.doubles(told.stamps);
    else if (tag === TOLD_PUBLISHERS_TAG) reader.int32s(told.publishers);
    else if (tag === TOLD_PUBLISHER_ID_TAG) told.publisherIds.push(readText(reader, texts));
    else return undefined;
  }
  reader.end = outerEnd;
  return told;
}

function writeOthers({ stamps, publishers, publisherIds }: ClusterRecords, writer: Writer): void {
  writer.doubles(TOLD_STAMPS_TAG, stamps);
  writer.int32s(TOLD_PUBLISHERS_TAG, publishers);
  for (const id of publisherIds) writer.string(TOLD_PUBLISHER_ID_TAG, id);
}

/** Bytes of a member with its tag and length, or of a number with the tag before it. */
function memberSize(length: number): number {
  return 1 + varintSize(length) + length;
}

function writeHead(target: Uint8Array, start: number, tag: number, value: number): number {
  return writeVarint(target, writeVarint(target, start, tag), value);
}
