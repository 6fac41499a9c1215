import type { DataFormat, TopicRecord } from '@ubii/proto';
import type { TopicPattern } from './topic-pattern.ts';

/** Options of a subscription. */
export interface SubscribeOptions<F extends DataFormat = DataFormat> {
  /** Only records of this data format are delivered. @default every format */
  readonly format?: F;
  /** At most this many records of a topic per second; the newest is never withheld permanently. @default no limit */
  readonly maxRateHz?: number;
  /** Records an async iterator holds for a slow consumer before the oldest is dropped. @default 1000 */
  readonly bufferSize?: number;
}

/**
 * Records of the topics a pattern selects, as callbacks and as async iterables. Each record comes
 * once, however many patterns match it; records without a value do not come. Records that arrive
 * before the first consumer wait for it, up to `bufferSize`. A subscription stands through
 * reconnects; after one, the newest record of a topic may come a second time. It ends with `close()`
 * or with the client.
 */
export interface Subscription<F extends DataFormat = DataFormat> extends AsyncIterable<
  TopicRecord<F>
> {
  /** The subscribed topic or pattern. */
  readonly pattern: TopicPattern;
  /** Calls `fn` for every record from now on. Each call adds a callback. */
  onRecord(fn: (record: TopicRecord<F>) => void): this;
  /**
   * Resolves once the master has accepted the subscription; waits while there is no connection.
   * Rejects with the `ServiceError` when the master refuses it, with a `ConnectionError` when the
   * subscription or the client is closed before.
   */
  readonly ready: Promise<void>;
  /** Ends the subscription, its callbacks and its iterators. Resolves once the master knows, or the link is gone. */
  close(): Promise<void>;
  /** Records that slow iterators of this subscription did not get. */
  readonly dropped: number;
}
