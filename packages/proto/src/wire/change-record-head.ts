import { Reader } from '../binary/reader.ts';
import { skipField } from '../binary/skip-field.ts';
import { writeMessage } from '../binary/write-message.ts';
import type { Writer } from '../binary/writer.ts';
import { DecodeError } from '../decode-error.ts';
import { encodeTimestamp } from '../generated/codec.ts';
import { timestampFromMs } from '../timestamp.ts';
import { CLIENT_ID_TAG, TIMESTAMP_TAG, TOPIC_TAG } from './tags.ts';

/** Members of an encoded record with other contents. What is left out stays as it is. */
export interface RecordHeadChange {
  readonly topic?: string | undefined;
  /** Timestamp of a record that has one, milliseconds since the Unix epoch. */
  readonly timeMs?: number | undefined;
  /** Client id of a record that states one. */
  readonly clientId?: string | undefined;
}

/**
 * Returns an encoded record with another topic, timestamp or client id. All other bytes stay as they are, and in
 * their order, unknown fields included.
 *
 * @throws DecodeError when the outer structure is broken
 */
export function changeRecordHead(record: Uint8Array, change: RecordHeadChange): Uint8Array {
  const { topic, timeMs, clientId } = change;
  if (topic === undefined && timeMs === undefined && clientId === undefined) return record;
  const replaced = new Map<number, boolean>([
    [TOPIC_TAG, topic !== undefined],
    [TIMESTAMP_TAG, timeMs !== undefined],
    [CLIENT_ID_TAG, clientId !== undefined],
  ]);
  const found = new Set<number>();
  const kept = rangesWithout(record, (tag) => {
    const isReplaced = replaced.get(tag) === true;
    if (isReplaced) found.add(tag);
    return isReplaced;
  });
  const head = writeMessage((_: RecordHeadChange, writer: Writer) => {
    if (topic !== undefined) writer.string(TOPIC_TAG, topic);
    if (timeMs !== undefined && found.has(TIMESTAMP_TAG)) {
      const opened = writer.open(TIMESTAMP_TAG);
      encodeTimestamp(timestampFromMs(timeMs), writer);
      writer.close(opened);
    }
    if (clientId !== undefined && found.has(CLIENT_ID_TAG)) writer.string(CLIENT_ID_TAG, clientId);
  }, change);
  return joined(head, record, kept);
}

interface Range {
  readonly start: number;
  end: number;
}

/** Ranges of the fields that stay. */
function rangesWithout(record: Uint8Array, isReplaced: (tag: number) => boolean): Range[] {
  const reader = new Reader(record);
  const ranges: Range[] = [];
  try {
    while (reader.pos < reader.end) {
      const start = reader.pos;
      const tag = reader.tag();
      skipField(reader, tag);
      if (isReplaced(tag)) continue;
      const last = ranges.at(-1);
      if (last?.end === start) last.end = reader.pos;
      else ranges.push({ start, end: reader.pos });
    }
  } catch (cause) {
    throw DecodeError.wrap('ubii.topicData.TopicDataRecord', record.length, cause);
  }
  return ranges;
}

function joined(head: Uint8Array, record: Uint8Array, ranges: readonly Range[]): Uint8Array {
  const length = ranges.reduce((sum, { start, end }) => sum + end - start, head.length);
  const changed = new Uint8Array(length);
  changed.set(head);
  let offset = head.length;
  for (const { start, end } of ranges) {
    changed.set(record.subarray(start, end), offset);
    offset += end - start;
  }
  return changed;
}
