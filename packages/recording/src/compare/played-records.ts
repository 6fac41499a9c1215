import type { RecordsReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { ComparedSpan } from './compare-options.ts';

/**
 * Reads what a playback of a span emits, with the time at which that is: first the value of each topic where it begins, then the
 * records after that.
 */
export async function* playedRecords(
  reader: RecordsReader,
  topics: readonly string[],
  span: ComparedSpan | undefined,
): AsyncGenerator<RecordedRecord> {
  const { startNs, endNs } = reader.summary;
  const fromNs = span?.fromNs ?? startNs;
  const latest = await reader.latestAt(fromNs, topics);
  for (const record of latest.values()) yield { ...record, logTimeNs: fromNs };
  yield* reader.records({ topics, fromNs: fromNs + 1n, untilNs: span?.untilNs ?? endNs });
}
