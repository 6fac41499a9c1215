import { describeRecord } from '../records/describe-record.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import { nsOf } from './nanoseconds.ts';

/** A record as it stands in files, with the time of its publisher. */
export function recordedOf(
  { topic, clientId }: Pick<RecordedRecord, 'topic' | 'clientId'>,
  record: Uint8Array,
  timeMs: number,
): RecordedRecord {
  const logTimeNs = nsOf(timeMs);
  const { timestampMs } = describeRecord(record);
  const publishTimeNs = timestampMs === undefined ? logTimeNs : nsOf(timestampMs);
  return { topic, clientId, record, logTimeNs, publishTimeNs };
}
