import { decode, encode, timestampFromMs, timestampToMs } from '@ubii/proto';
import { readRecordHead } from '@ubii/proto/wire';
import type { RecordedRecord } from '@ubii/recording';

/** A record to be published again. */
export interface ReplayedRecord {
  readonly topic: string;
  /** The encoded `TopicDataRecord`. */
  readonly bytes: Uint8Array;
  readonly valueField: number;
}

/**
 * Makes a record one of today: with another topic, publisher and time. Its age when it arrived stays what it was.
 *
 * @param nowMs milliseconds since the Unix epoch
 * @throws DecodeError when the bytes are no record
 */
export function replayedRecord(
  { record, logTimeNs }: RecordedRecord,
  { topic, clientId, nowMs }: { topic: string; clientId: string; nowMs: number },
): ReplayedRecord {
  const message = decode('ubii.topicData.TopicDataRecord', record);
  const taken = timestampToMs(message.timestamp);
  const ageMs = taken === undefined ? 0 : Number(logTimeNs) / 1e6 - taken;
  const bytes = encode('ubii.topicData.TopicDataRecord', {
    ...message,
    topic,
    clientId,
    timestamp: timestampFromMs(nowMs - ageMs),
  });
  return { topic, bytes, valueField: readRecordHead(bytes).valueField };
}
