import type { RecordingReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';

type Query = Parameters<RecordingReader['records']>[0];

/** The records of a recording in an array. */
export async function readRecords(
  reader: RecordingReader,
  query?: Query,
): Promise<RecordedRecord[]> {
  const records = [];
  for await (const record of reader.records(query)) records.push(record);
  return records;
}
