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
  new TopicDataScan(frame, { topics }).run(sink);
}

/** Settings of a scan. */
export interface ScanOptions {
  /** Remembers topics from frame to frame, for callers that scan many frames. */
  readonly topics?: TextCache | undefined;
  /** Most fields of one record or other member, those of nested messages included. Default: no limit. */
  readonly maxMemberFields?: number;
}

/** Scans a frame as `scanTopicData` does, in as many steps as its sink wants. [TD-71] */
export class TopicDataScan {
  readonly #reader: Reader;
  readonly #topics: TextCache | undefined;
  readonly #maxMemberFields: number;
  /** End of the list that the scan is in; 0: it is in none. */
  #listEnd = 0;
  #isPaused = false;
  #isSkipping = false;
  #skippedRecords = 0;

  constructor(
    frame: Uint8Array,
    { topics, maxMemberFields = Number.MAX_SAFE_INTEGER }: ScanOptions = {},
  ) {
    this.#reader = new Reader(frame);
    this.#topics = topics;
    this.#maxMemberFields = maxMemberFields;
  }

  /** Fields read so far: what the check costs grows with their number. */
  get fields(): number {
    return this.#reader.fields;
  }

  /** Records that were stepped over since `skipRecords`. */
  get skippedRecords(): number {
    return this.#skippedRecords;
  }

  /** Makes `run` return after the member at hand. For its sink. */
  pause(): void {
    this.#isPaused = true;
  }

  /** From now on records are stepped over and counted, without a check of their structure. */
  skipRecords(): void {
    this.#isSkipping = true;
  }

  /**
   * Goes on to the end of the frame, or until the sink pauses the scan.
   *
   * @param maxFields pauses after the member with which it has read so many. Default: no limit
   * @returns whether the end was reached
   * @throws DecodeError at the first record that fails, after those before it were handed over
   */
  run(sink: TopicDataSink, maxFields = Number.MAX_SAFE_INTEGER): boolean {
    const reader = this.#reader;
    const frameEnd = reader.input.byteLength;
    const stopAt = reader.fields + maxFields;
    this.#isPaused = false;
    try {
      while (!this.#isPaused && reader.fields < stopAt) {
        if (this.#listEnd > 0) this.#scanList(sink, stopAt);
        else if (reader.pos < reader.end) this.#scanMember(sink);
        else break;
      }
    } catch (cause) {
      throw cause instanceof MalformedError
        ? DecodeError.wrap('ubii.topicData.TopicData', frameEnd, cause)
        : cause;
    }
    return this.#listEnd === 0 && reader.pos >= frameEnd;
  }

  #scanMember(sink: TopicDataSink): void {
    const reader = this.#reader;
    this.#limitFields();
    const tag = reader.tag();
    switch (tag) {
      case RECORD_TAG:
        return this.#scanRecord(sink);
      case LIST_TAG:
        reader.enter();
        this.#listEnd = reader.end;
        return;
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

  /** A member cannot be read in parts. */
  #limitFields(): void {
    this.#reader.maxFields = this.#reader.fields + this.#maxMemberFields;
  }

  #scanList(sink: TopicDataSink, stopAt: number): void {
    const reader = this.#reader;
    while (reader.pos < reader.end) {
      if (this.#isPaused || reader.fields >= stopAt) return;
      this.#limitFields();
      const tag = reader.tag();
      if (tag === LIST_ELEMENT_TAG) this.#scanRecord(sink);
      else skipField(reader, tag);
    }
    this.#listEnd = 0;
    reader.end = reader.input.byteLength;
  }

  #scanRecord(sink: TopicDataSink): void {
    const reader = this.#reader;
    if (this.#isSkipping) {
      reader.skip(reader.length());
      this.#skippedRecords++;
      return;
    }
    const outerEnd = reader.enter();
    const start = reader.pos;
    let topic = '';
    let valueField = 0;
    while (reader.pos < reader.end) {
      const tag = reader.tag();
      if (tag === TOPIC_TAG) {
        topic = readTopic(reader, this.#topics);
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
