import { DecodeError } from '../decode-error.ts';
import { checkField, checkMessage, fieldOf } from './check-message.ts';
import { messageCheck } from './check-table.ts';
import { Cursor } from './cursor.ts';
import { MalformedError } from './malformed-error.ts';
import { ERROR_TAG, LIST_ELEMENT_TAG, LIST_TAG, RECORD_TAG } from './tags.ts';
import { readUtf8 } from './utf8.ts';

/** Takes what `scanTopicData` finds. */
export interface TopicDataSink {
  /**
   * A record, in publishing order.
   *
   * @param topic empty when the record has none
   * @param start first byte of the encoded `TopicDataRecord` within the frame
   * @param end first byte after it
   * @param valueField number of the value member, 0 when there is none
   */
  record(topic: string, start: number, end: number, valueField: number): void;
  /**
   * An error member.
   *
   * @param start first byte of the encoded `Error` within the frame
   * @param end first byte after it
   */
  error(start: number, end: number): void;
}

const RECORD = messageCheck('ubii.topicData.TopicDataRecord');
const ERROR = messageCheck('ubii.general.Error');
const TOPIC_TAG = 10;

/**
 * Checks a frame of the topic-data channel and hands over its records without decoding them:
 * nothing is allocated per field, except the text of the topic. The structure of nested messages is
 * checked against the schema, unknown fields pass. [TD-10, TD-11, TD-12]
 *
 * Differs from decoding the frame as one `TopicData` in that each occurrence of a member counts,
 * where decoding would merge or replace them.
 *
 * @throws DecodeError at the first record that fails, after those before it were handed over
 */
export function scanTopicData(frame: Uint8Array, sink: TopicDataSink): void {
  const cursor = new Cursor(frame, 0, frame.length);
  try {
    while (cursor.pos < frame.length) {
      const tag = cursor.readTag();
      switch (tag) {
        case RECORD_TAG:
          scanRecord(cursor, sink);
          break;
        case LIST_TAG:
          scanList(cursor, sink);
          break;
        case ERROR_TAG: {
          const end = enter(cursor);
          const start = cursor.pos;
          checkMessage(cursor, ERROR);
          sink.error(start, cursor.pos);
          cursor.end = end;
          break;
        }
        default:
          cursor.skipField(tag);
      }
    }
  } catch (cause) {
    throw cause instanceof MalformedError
      ? DecodeError.wrap('ubii.topicData.TopicData', frame.length, cause)
      : cause;
  }
}

/** Narrows the cursor to a length-delimited member; returns the end to put back. */
function enter(cursor: Cursor): number {
  const outer = cursor.end;
  const length = cursor.readLength();
  cursor.end = cursor.pos + length;
  return outer;
}

function scanList(cursor: Cursor, sink: TopicDataSink): void {
  const outer = enter(cursor);
  while (cursor.pos < cursor.end) {
    const tag = cursor.readTag();
    if (tag === LIST_ELEMENT_TAG) scanRecord(cursor, sink);
    else cursor.skipField(tag);
  }
  cursor.end = outer;
}

function scanRecord(cursor: Cursor, sink: TopicDataSink): void {
  const outer = enter(cursor);
  const start = cursor.pos;
  let topic = '';
  let valueField = 0;
  while (cursor.pos < cursor.end) {
    const tag = cursor.readTag();
    if (tag === TOPIC_TAG) {
      const length = cursor.readLength();
      topic = readUtf8(cursor.bytes, cursor.pos, cursor.pos + length);
      cursor.pos += length;
      continue;
    }
    const field = fieldOf(RECORD, tag);
    if (field === undefined) {
      cursor.skipField(tag);
      continue;
    }
    if (field.isOneofMember) valueField = field.number;
    checkField(cursor, field, tag & 7);
  }
  const end = cursor.pos;
  cursor.end = outer;
  sink.record(topic, start, end, valueField);
}

/**
 * Number of the value member of an encoded record, 0 when it has none.
 *
 * @param record a record that was checked before
 * @throws DecodeError when the outer structure is broken
 */
export function recordValueField(record: Uint8Array): number {
  const cursor = new Cursor(record, 0, record.length);
  let valueField = 0;
  try {
    while (cursor.pos < record.length) {
      const tag = cursor.readTag();
      const field = fieldOf(RECORD, tag);
      if (field?.isOneofMember === true) valueField = field.number;
      cursor.skipField(tag);
    }
  } catch (cause) {
    throw DecodeError.wrap(RECORD.name, record.length, cause);
  }
  return valueField;
}
