import type { TopicEntry } from './topic-entry.ts';

/** Receives the records of one subscriber. */
export interface Receiver {
  /** A record was published, and is in `entry` now. The hot path. */
  deliver(entry: TopicEntry, record: Uint8Array, isEvent: boolean): void;
  /** The retained record, unless a newer one than number `sinceSequence` came by itself. */
  replay(entry: TopicEntry, sinceSequence: number): void;
  /** The value of the topic was deleted. [TD-42] */
  handleGone(entry: TopicEntry): void;
  /** The value has expired: what waits of it is dropped [TD-47]. */
  withdraw(entry: TopicEntry): void;
  /** The subscriber has no subscription to the topic any more. */
  forgive(entry: TopicEntry): void;
}
