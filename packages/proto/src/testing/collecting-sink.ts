import type { TopicDataSink } from '../wire/index.ts';

/** A record as `scanTopicData` hands it over. */
export interface ScannedRecord {
  readonly topic: string;
  readonly start: number;
  readonly end: number;
  readonly valueField: number;
}

/** A sink that keeps everything. */
export interface CollectingSink extends TopicDataSink {
  readonly records: ScannedRecord[];
  readonly errors: { readonly start: number; readonly end: number }[];
}

/** A sink that keeps everything. */
export function createCollectingSink(): CollectingSink {
  const records: ScannedRecord[] = [];
  const errors: { start: number; end: number }[] = [];
  return {
    records,
    errors,
    record: (topic, start, end, valueField) => void records.push({ topic, start, end, valueField }),
    error: (start, end) => void errors.push({ start, end }),
  };
}
