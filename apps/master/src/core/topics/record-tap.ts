import type { TopicEntry } from './topic-entry.ts';

/** Picks up records to record them. */
export interface RecordTaker {
  /** The hot path, called after the record was stored in its entry. */
  take(entry: TopicEntry, record: Uint8Array): void;
  /** The same for a value that stands at another master, and arrives only now. [CU-17] */
  takeValue(entry: TopicEntry, record: Uint8Array): void;
}

/** Where records of all topics are picked up [RC-50]. */
export class RecordTap {
  /** Undefined while nothing is recorded. */
  taker: RecordTaker | undefined = undefined;
}
