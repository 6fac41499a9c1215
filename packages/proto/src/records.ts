import { Reader } from './binary/reader.ts';
import { skipField } from './binary/skip-field.ts';
import { writeMessage } from './binary/write-message.ts';
import type { Writer } from './binary/writer.ts';
import type { DataFormat, DataFormatValues } from './data-formats/data-format-values.ts';
import { codecOf, type MessageType } from './codec.ts';
import { DATA_FORMATS } from './data-formats/data-formats.ts';
import { DecodeError } from './decode-error.ts';
import {
  decodeErrorMessage,
  decodeNodeMessage,
  decodeTopicDataRecord,
  encodeTimestamp,
} from './generated/codec.ts';
import type { ErrorMessage, NodeMessage, TopicDataRecord } from './generated/messages.ts';
import type { Init } from './init.ts';
import { timestampFromMs, timestampToMs } from './timestamp.ts';
import {
  CLIENT_ID_TAG,
  EXPIRY_MS_TAG,
  KEEP_SECONDS_TAG,
  RECORD_EXTENSION_TAG,
  ERROR_TAG,
  LIST_ELEMENT_TAG,
  LIST_TAG,
  NODE_MESSAGE_TAG,
  RECORD_TAG,
  TIMESTAMP_TAG,
  TOPIC_TAG,
} from './wire/tags.ts';

/** A value that was published on a topic. Narrow by `format` to get the type of `value`. */
export type TopicRecord<F extends DataFormat = DataFormat> = F extends DataFormat
  ? {
      topic: string;
      format: F;
      value: DataFormatValues[F];
      /** When the value was taken, by the publisher's clock: milliseconds since the Unix epoch. */
      timestampMs: number | undefined;
      /** Client id of the publisher, as stated by the publisher; empty when it stated none. */
      clientId: string;
    }
  : never;

/** A record without a value; existing clients send and expect them. [TD-13] */
export interface EmptyRecord {
  topic: string;
  format: undefined;
  value: undefined;
  timestampMs: number | undefined;
  clientId: string;
}

/** Argument of `encodeRecord`: members of the value may be left out, as in `encode`. */
export type RecordInit<F extends DataFormat = DataFormat> =
  | (F extends DataFormat
      ? {
          readonly topic: string;
          readonly format: F;
          readonly value: Init<DataFormatValues[F]>;
          readonly timestampMs?: number | undefined;
          readonly clientId?: string | undefined;
          /** How long the value outlives its publisher, seconds. [TD-43] @default 0 */
          readonly keepSeconds?: number | undefined;
          /** How long the value stands while no newer record comes, milliseconds. [TD-47] @default 0, as long as any */
          readonly expiryMs?: number | undefined;
        }
      : never)
  | {
      readonly topic: string;
      readonly format?: undefined;
      readonly value?: undefined;
      readonly timestampMs?: number | undefined;
      readonly clientId?: string | undefined;
      readonly keepSeconds?: undefined;
      readonly expiryMs?: number | undefined;
    };

/** Content of a frame of the topic-data channel. */
export interface DecodedTopicData {
  records: (TopicRecord | EmptyRecord)[];
  /** Present when the master refused something. */
  error: ErrorMessage | undefined;
  /** Messages between the master and a node; empty for other clients. [EX-20] */
  nodeMessages: NodeMessage[];
  /** One for each record or node message that fails, and one when the frame itself is broken. */
  failed: DecodeError[];
}

const RECORD_TYPE = 'ubii.topicData.TopicDataRecord';
const NODE_MESSAGE_TYPE = 'ubii.extension.NodeMessage';

/**
 * Encodes a record as a `TopicDataRecord`.
 *
 * @throws TypeError when the value is missing or has members of the wrong type
 */
export function encodeRecord(record: RecordInit): Uint8Array {
  return writeMessage(writeRecord, record);
}

/** Writes field by field: a `TopicDataRecord` message would have to be looked at for 42 members. */
function writeRecord(record: RecordInit, writer: Writer): void {
  writer.string(TOPIC_TAG, record.topic);
  if (record.timestampMs !== undefined) {
    const opened = writer.open(TIMESTAMP_TAG);
    encodeTimestamp(timestampFromMs(record.timestampMs), writer);
    writer.close(opened);
  }
  if (record.format !== undefined) writeValue(writer, record.format, record.value, record.topic);
  if (record.clientId) writer.string(CLIENT_ID_TAG, record.clientId);
  if (record.keepSeconds || record.expiryMs) {
    const opened = writer.open(RECORD_EXTENSION_TAG);
    if (record.keepSeconds) writer.int32(KEEP_SECONDS_TAG, record.keepSeconds);
    if (record.expiryMs) writer.int32(EXPIRY_MS_TAG, record.expiryMs);
    writer.close(opened);
  }
}

function writeValue(writer: Writer, format: DataFormat, value: unknown, topic: string): void {
  if (value === undefined || value === null) {
    throw new TypeError(`the record on ${topic} has no ${format} value`);
  }
  const { fieldNumber, messageType } = DATA_FORMATS[format];
  const tag = fieldNumber << 3;
  switch (format) {
    case 'double':
      return writer.double(tag | 1, value as number);
    case 'float':
      return writer.float(tag | 5, value as number);
    case 'int32':
      return writer.int32(tag, value as number);
    case 'bool':
      return writer.bool(tag, value as boolean);
    case 'string':
      return writer.string(tag | 2, value as string);
    default: {
      const { encode } = codecOf(messageType as MessageType);
      const opened = writer.open(tag | 2);
      (encode as (message: unknown, writer: Writer) => void)(value, writer);
      writer.close(opened);
    }
  }
}

/**
 * Decodes a `TopicDataRecord`.
 *
 * @param bytes borrowed: the data of pictures is a view of it
 * @throws DecodeError when the bytes are not a record
 */
export function decodeRecord(bytes: Uint8Array): TopicRecord | EmptyRecord {
  try {
    return recordOf(decodeTopicDataRecord(new Reader(bytes)));
  } catch (cause) {
    throw DecodeError.wrap(RECORD_TYPE, bytes.byteLength, cause);
  }
}

/** Whether a member of `TopicDataRecord` describes the record, and is not its value. */
export function isRecordMember(member: string): boolean {
  return (
    member === 'topic' || member === 'timestamp' || member === 'clientId' || member === 'extension'
  );
}

/** The record of a decoded `TopicDataRecord` message. */
export function recordOf(message: TopicDataRecord): TopicRecord | EmptyRecord {
  let format: DataFormat | undefined;
  for (const member in message) {
    if (!isRecordMember(member)) {
      format = member as DataFormat;
    }
  }
  return {
    topic: message.topic,
    format,
    value: format === undefined ? undefined : message[format],
    timestampMs: timestampToMs(message.timestamp),
    clientId: message.clientId,
  } as TopicRecord | EmptyRecord;
}

/**
 * Decodes a frame of the topic-data channel, single record or list. A record that cannot be decoded
 * does not lose the others. Never throws.
 *
 * @param bytes borrowed: the data of pictures is a view of it
 */
export function decodeTopicData(bytes: Uint8Array): DecodedTopicData {
  const result: DecodedTopicData = { records: [], error: undefined, nodeMessages: [], failed: [] };
  try {
    const reader = new Reader(bytes);
    while (reader.pos < reader.end) readMember(reader, result);
  } catch (cause) {
    result.failed.push(DecodeError.wrap('ubii.topicData.TopicData', bytes.byteLength, cause));
  }
  return result;
}

function readMember(reader: Reader, result: DecodedTopicData): void {
  const tag = reader.tag();
  switch (tag) {
    case RECORD_TAG:
      return readRecord(reader, result);
    case LIST_TAG: {
      const outerEnd = reader.enter();
      while (reader.pos < reader.end) {
        const elementTag = reader.tag();
        if (elementTag === LIST_ELEMENT_TAG) readRecord(reader, result);
        else skipField(reader, elementTag);
      }
      reader.end = outerEnd;
      return;
    }
    case ERROR_TAG: {
      const outerEnd = reader.enter();
      result.error = decodeErrorMessage(reader, result.error);
      reader.end = outerEnd;
      return;
    }
    case NODE_MESSAGE_TAG:
      return readNodeMessage(reader, result);
    default:
      skipField(reader, tag);
  }
}

function readRecord(reader: Reader, result: DecodedTopicData): void {
  const outerEnd = reader.enter();
  const { pos: start, end } = reader;
  try {
    result.records.push(recordOf(decodeTopicDataRecord(reader)));
  } catch (cause) {
    result.failed.push(DecodeError.wrap(RECORD_TYPE, end - start, cause));
  }
  reader.pos = end;
  reader.end = outerEnd;
}

function readNodeMessage(reader: Reader, result: DecodedTopicData): void {
  const outerEnd = reader.enter();
  const { pos: start, end } = reader;
  try {
    result.nodeMessages.push(decodeNodeMessage(reader));
  } catch (cause) {
    result.failed.push(DecodeError.wrap(NODE_MESSAGE_TYPE, end - start, cause));
  }
  reader.pos = end;
  reader.end = outerEnd;
}
