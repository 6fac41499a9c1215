import { Reader } from '../binary/reader.ts';
import { skipField } from '../binary/skip-field.ts';
import { DecodeError } from '../decode-error.ts';
import { decodeTimestamp } from '../generated/codec.ts';
import type { Timestamp } from '../generated/messages.ts';
import { timestampToMs } from '../timestamp.ts';
import { TIMESTAMP_TAG } from './tags.ts';

/**
 * Reads when the value of an encoded record was taken, by the publisher's clock; the value is stepped over.
 *
 * @returns milliseconds since the Unix epoch; undefined when the record has no time that is plausible
 * @throws DecodeError when the outer structure is broken
 */
export function readRecordTimestamp(record: Uint8Array): number | undefined {
  const reader = new Reader(record);
  let timestamp: Timestamp | undefined;
  try {
    while (reader.pos < reader.end) {
      const tag = reader.tag();
      if (tag === TIMESTAMP_TAG) {
        const outerEnd = reader.enter();
        timestamp = decodeTimestamp(reader, timestamp);
        reader.end = outerEnd;
      } else skipField(reader, tag);
    }
  } catch (cause) {
    throw DecodeError.wrap('ubii.topicData.TopicDataRecord', record.length, cause);
  }
  return timestampToMs(timestamp);
}
