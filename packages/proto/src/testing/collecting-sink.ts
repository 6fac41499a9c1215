import type { TopicDataSink } from '../wire/index.ts';

/** A record as `scanTopicData` hands it over. */
export interface ScannedRecord {
  readonly topic: string;
  readonly start: number;
  readonly end: number;
  readonly valueField: number;
}

/** Any other member as `scanTopicData` hands it over. */
export interface ScannedMessage {
  readonly start: number;
  readonly end: number;
}

/** A sink that keeps everything. */
export interface CollectingSink extends TopicDataSink {
  readonly records: ScannedRecord[];
  readonly errors: ScannedMessage[];
  readonly nodeMessages: ScannedMessage[];
}

/** A sink that keeps everything. */
export function createCollectingSink(): CollectingSink {
  const records: ScannedRecord[] = [];
  const errors: ScannedMessage[] = [];
  const nodeMessages: ScannedMessage[] = [];
  return {
    records,
    errors,
    nodeMessages,
    record: (topic, start, end, valueField) => void records.push({ topic, start, end, valueField }),
    error: (start, end) => void errors.push({ start, end }),
    nodeMessage: (start, end) => void nodeMessages.push({ start, end }),
  };
}
