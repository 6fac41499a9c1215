import { MalformedError } from '../binary/malformed-error.ts';
import { Reader } from '../binary/reader.ts';
import { skipField } from '../binary/skip-field.ts';
import type { TextCache } from '../binary/text-cache.ts';
import { DecodeError } from '../decode-error.ts';
import { checkField, checkMessage, fieldOf } from './check-message.ts';
import { messageCheck } from './check-table.ts';
import {
  ERROR_TAG,
  LIST_ELEMENT_TAG,
  LIST_TAG,
  NODE_MESSAGE_TAG,
  RECORD_TAG,
  TOPIC_TAG,
} from './tags.ts';

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
  /**
   * A message between the master and a node. [EX-20] A sink without this steps over it.
   *
   * @param start first byte of the encoded `NodeMessage` within the frame
   * @param end first byte after it
   */
  nodeMessage?(start: number, end: number): void;
}

const RECORD = messageCheck('ubii.topicData.TopicDataRecord');
const ERROR = messageCheck('ubii.general.Error');
const NODE_MESSAGE = messageCheck('ubii.extension.NodeMessage');

/**
 * Checks a frame of the topic-data channel and hands over its records without decoding them:
 * nothing is allocated per field, except the text of the topic. The structure of nested messages is
 * checked against the schema, unknown fields pass. [TD-10, TD-11, TD-12]
 *
 * Differs from decoding the frame as one `TopicData` in that each occurrence of a member counts,
 * where decoding would merge or replace them.
 *
 * @param topics remembers topics from frame to frame, for callers that scan many frames
 * @throws DecodeError at the first record that fails, after those before it were handed over
 */
export function scanTopicData(frame: Uint8Array, sink: TopicDataSink, topics?: TextCache): void {
  const reader = new Reader(frame);
  try {
    while (reader.pos < reader.end) scanMember(reader, sink, topics);
  } catch (cause) {
    throw cause instanceof MalformedError
      ? DecodeError.wrap('ubii.topicData.TopicData', frame.length, cause)
      : cause;
  }
}

function scanMember(reader: Reader, sink: TopicDataSink, topics?: TextCache): void {
  const tag = reader.tag();
  switch (tag) {
    case RECORD_TAG:
      return scanRecord(reader, sink, topics);
    case LIST_TAG:
      return scanList(reader, sink, topics);
    case ERROR_TAG: {
      const outerEnd = reader.enter();
      const start = reader.pos;
      checkMessage(reader, ERROR);
      reader.end = outerEnd;
      return sink.error(start, reader.pos);
    }
    case NODE_MESSAGE_TAG: {
      const outerEnd = reader.enter();
      const start = reader.pos;
      checkMessage(reader, NODE_MESSAGE);
      reader.end = outerEnd;
      return sink.nodeMessage?.(start, reader.pos);
    }
    default:
      skipField(reader, tag);
  }
}

function scanList(reader: Reader, sink: TopicDataSink, topics?: TextCache): void {
  const outerEnd = reader.enter();
  while (reader.pos < reader.end) {
    const tag = reader.tag();
    if (tag === LIST_ELEMENT_TAG) scanRecord(reader, sink, topics);
    else skipField(reader, tag);
  }
  reader.end = outerEnd;
}

function scanRecord(reader: Reader, sink: TopicDataSink, topics?: TextCache): void {
  const outerEnd = reader.enter();
  const start = reader.pos;
  let topic = '';
  let valueField = 0;
  while (reader.pos < reader.end) {
    const tag = reader.tag();
    if (tag === TOPIC_TAG) {
      topic = readTopic(reader, topics);
      continue;
    }
    const field = fieldOf(RECORD, tag);
    if (field === undefined) {
      skipField(reader, tag);
      continue;
    }
    if (field.isOneofMember) valueField = field.number;
    checkField(reader, field, tag & 7);
  }
  reader.end = outerEnd;
  sink.record(topic, start, reader.pos, valueField);
}

function readTopic(reader: Reader, topics: TextCache | undefined): string {
  if (topics === undefined) return reader.string();
  const length = reader.length();
  const start = reader.pos;
  reader.pos = start + length;
  return topics.read(reader.input, start, reader.pos);
}

/**
 * Number of the value member of an encoded record, 0 when it has none.
 *
 * @param record a record that was checked before
 * @throws DecodeError when the outer structure is broken
 */
export function recordValueField(record: Uint8Array): number {
  const reader = new Reader(record);
  let valueField = 0;
  try {
    while (reader.pos < reader.end) {
      const tag = reader.tag();
      const field = fieldOf(RECORD, tag);
      if (field?.isOneofMember === true) valueField = field.number;
      skipField(reader, tag);
    }
  } catch (cause) {
    throw DecodeError.wrap(RECORD.name, record.length, cause);
  }
  return valueField;
}
