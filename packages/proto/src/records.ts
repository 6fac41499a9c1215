import type { DataFormat, DataFormatValues } from './data-formats/data-format-values.ts';
import { DATA_FORMATS } from './data-formats/data-formats.ts';
import { DecodeError } from './decode-error.ts';
import {
  CODECS,
  decodeErrorMessage,
  decodeTopicDataRecord,
  encodeTimestamp,
} from './generated/codec.ts';
import type { ErrorMessage, TopicDataRecord } from './generated/messages.ts';
import type { Init } from './init.ts';
import {
  createReader,
  createWriter,
  open,
  skip,
  writeString,
  type Reader,
  type Writer,
} from './protobuf.ts';
import { timestampFromMs, timestampToMs } from './timestamp.ts';
import { ERROR_TAG, LIST_ELEMENT_TAG, LIST_TAG, RECORD_TAG } from './wire/tags.ts';

/** A value that was published on a topic. Narrow by `format` to get the type of `value`. */
export type TopicRecord<F extends DataFormat = DataFormat> = F extends DataFormat
  ? {
      topic: string;
      format: F;
      value: DataFormatValues[F];
      /** When the value was taken, by the publisher's clock: milliseconds since the Unix epoch. */
      timestampMs: number | undefined;
      /** Who published it, as far as the publisher said; empty when it did not. */
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

/** What `encodeRecord` takes: members of the value may be left out, as in `encode`. */
export type RecordInit<F extends DataFormat = DataFormat> =
  | (F extends DataFormat
      ? {
          readonly topic: string;
          readonly format: F;
          readonly value: Init<DataFormatValues[F]>;
          readonly timestampMs?: number | undefined;
          readonly clientId?: string | undefined;
        }
      : never)
  | {
      readonly topic: string;
      readonly format?: undefined;
      readonly value?: undefined;
      readonly timestampMs?: number | undefined;
      readonly clientId?: string | undefined;
    };

/** What a frame of the topic-data channel held. */
export interface DecodedTopicData {
  records: (TopicRecord | EmptyRecord)[];
  /** Present when the master refused something. */
  error: ErrorMessage | undefined;
  /** One for each record that could not be decoded, and one when the frame itself is broken. */
  failed: DecodeError[];
}

const RECORD_TYPE = 'ubii.topicData.TopicDataRecord';

/**
 * Encodes a record as a `TopicDataRecord`.
 *
 * @throws TypeError when the value is missing or has members of the wrong type
 */
export function encodeRecord(record: RecordInit): Uint8Array {
  const writer = createWriter();
  writeString(writer.uint32(10), record.topic);
  if (record.timestampMs !== undefined) {
    writer.uint32(18).fork();
    encodeTimestamp(timestampFromMs(record.timestampMs), writer);
    writer.ldelim();
  }
  if (record.format !== undefined) writeValue(writer, record.format, record.value, record.topic);
  if (record.clientId) writeString(writer.uint32(266), record.clientId);
  return writer.finish();
}

function writeValue(writer: Writer, format: DataFormat, value: unknown, topic: string): void {
  if (value === undefined || value === null) {
    throw new TypeError(`the record on ${topic} has no ${format} value`);
  }
  const { fieldNumber, messageType } = DATA_FORMATS[format];
  const tag = fieldNumber << 3;
  switch (format) {
    case 'double':
      writer.uint32(tag | 1).double(value as number);
      return;
    case 'float':
      writer.uint32(tag | 5).float(value as number);
      return;
    case 'int32':
      writer.uint32(tag).int32(value as number);
      return;
    case 'bool':
      writer.uint32(tag).bool(value as boolean);
      return;
    case 'string':
      writeString(writer.uint32(tag | 2), value as string);
      return;
    default: {
      const codec = CODECS[messageType as keyof typeof CODECS];
      writer.uint32(tag | 2).fork();
      (codec.encode as (message: unknown, writer: Writer) => void)(value, writer);
      writer.ldelim();
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
    return recordOf(decodeTopicDataRecord(createReader(bytes)));
  } catch (cause) {
    throw DecodeError.wrap(RECORD_TYPE, bytes.byteLength, cause);
  }
}

/** The record of a decoded `TopicDataRecord` message. */
export function recordOf(message: TopicDataRecord): TopicRecord | EmptyRecord {
  let format: DataFormat | undefined;
  for (const member in message) {
    if (member !== 'topic' && member !== 'timestamp' && member !== 'clientId') {
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
  const result: DecodedTopicData = { records: [], error: undefined, failed: [] };
  try {
    const reader = createReader(bytes);
    while (reader.pos < reader.len) readMember(reader, result);
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
      const end = open(reader);
      while (reader.pos < reader.len) {
        const elementTag = reader.tag();
        if (elementTag === LIST_ELEMENT_TAG) readRecord(reader, result);
        else skip(reader, elementTag);
      }
      reader.len = end;
      return;
    }
    case ERROR_TAG: {
      const end = open(reader);
      result.error = decodeErrorMessage(reader, result.error);
      reader.len = end;
      return;
    }
    default:
      skip(reader, tag);
  }
}

function readRecord(reader: Reader, result: DecodedTopicData): void {
  const outerEnd = open(reader);
  const { pos: start, len: end } = reader;
  try {
    result.records.push(recordOf(decodeTopicDataRecord(reader)));
  } catch (cause) {
    result.failed.push(DecodeError.wrap(RECORD_TYPE, end - start, cause));
  }
  reader.pos = end;
  reader.len = outerEnd;
}
