import type { TokenBucket } from './token-bucket.ts';
import type { TopicEntry, TopicOwner } from './topic-entry.ts';

/** A client as somebody who publishes. */
export interface PublishingClient extends TopicOwner {
  readonly recordBudget: TokenBucket;
  readonly byteBudget: TokenBucket;
}

/** The most memory a kept record may take, as a multiple of its length. */
const MOST_MEMORY = 2;

/** A record on its way into its topic. One object serves every record of a publisher, one after the other. */
export class Publication {
  /** Undefined: the master itself. */
  client: PublishingClient | undefined = undefined;
  topic = '';
  /** The message with the encoded record. Nobody writes to it any more. */
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

  /**
   * The bytes of the record, to be kept. Those that are most of the memory they lie in stay there: for
   * an image it is the copy, for a small record the allocation, that publishing would cost most. Others
   * are copied, or one record would keep the memory of a whole list.
   */
  keepRecord(): Uint8Array {
    const { frame, start, byteLength } = this;
    const { buffer, byteOffset } = frame;
    const record = new Uint8Array(buffer, byteOffset + start, byteLength);
    return buffer.byteLength <= MOST_MEMORY * byteLength ? record : record.slice();
  }
}
