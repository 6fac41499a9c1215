import type { TokenBucket } from './token-bucket.ts';
import type { TopicEntry, TopicOwner } from './topic-entry.ts';

/** A client as somebody who publishes. */
export interface PublishingClient extends TopicOwner {
  readonly recordBudget: TokenBucket;
  readonly byteBudget: TokenBucket;
}

/** A record on its way into its topic. One object serves every record of a publisher, one after the other. */
export class Publication {
  /** Undefined: the master itself. */
  client: PublishingClient | undefined = undefined;
  topic = '';
  /** Encoded bytes, borrowed: what is kept is copied. */
  frame: Uint8Array = new Uint8Array(0);
  start = 0;
  end = 0;
  valueField = 0;
  /** Monotonic and epoch milliseconds at which the frame arrived. */
  monotonicMs = 0;
  nowMs = 0;
  entry: TopicEntry | undefined = undefined;

  get byteLength(): number {
    return this.end - this.start;
  }
}
