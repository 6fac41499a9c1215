import type { TokenBucket } from '@ubii/timing';
import type { PublishLimits } from './publish-limits.ts';
import type { PublishRights } from './rights.ts';
import type { Throttle } from '../counters/throttle.ts';
import type { Shortage } from '../shares/shortage.ts';
import type { TopicEntry, TopicOwner } from './topic-entry.ts';

/** Counters of a client that publishes [EX-26]. */
export interface PublishedCounts {
  recordsIn: number;
  bytesIn: number;
  /** Records given to subscribers, once for each. */
  recordsCaused: number;
  bytesCaused: number;
}

/** A client as a publisher. */
export interface PublishingClient extends TopicOwner {
  readonly publishLimits: PublishLimits;
  readonly recordBudget: TokenBucket;
  readonly byteBudget: TokenBucket;
  readonly traffic: PublishedCounts;
  /** Throttle that reduces its budget. [EX-31] */
  readonly throttle: Throttle | undefined;
  /** Undefined: it publishes everywhere [AC-24]. */
  readonly publishRights: PublishRights | undefined;
}

/** The most memory a kept record may take, as a multiple of its length. */
const MAX_MEMORY = 2;
/** Small records share buffers of this size, bytes: at worst, one record keeps a whole buffer. */
const SHARED_BYTES = 2048;
/** Records up to this length are small, bytes. */
const SMALL_BYTES = 512;

const NO_BYTES = new Uint8Array(0) as Uint8Array;

/** A record on its way into its topic. One object serves every record of a publisher, one after the other. */
export class Publication {
  /** Undefined: the master itself. */
  client: PublishingClient | undefined = undefined;
  topic = '';
  /** The message with the encoded record. It is not modified any more. */
  frame = NO_BYTES;
  start = 0;
  end = 0;
  valueField = 0;
  /** Monotonic and epoch milliseconds at which the frame arrived. */
  monotonicMs = 0;
  nowMs = 0;
  entry: TopicEntry | undefined = undefined;
  /** The shortage because of which it was refused. */
  shortage: Shortage | undefined = undefined;
  /** Buffer for the copy of the next small record. */
  #shared: ArrayBuffer | undefined = undefined;
  #sharedLength = 0;

  get byteLength(): number {
    return this.end - this.start;
  }

  /**
   * The bytes of the record, to be kept. Those that are most of the memory they lie in stay there, for
   * which an image need not be copied. Others are copied, or one record would keep the memory of a
   * whole list; small ones next to each other, because getting memory costs more than ten copies.
   */
  keepRecord(): Uint8Array {
    const { frame, start, byteLength } = this;
    const { buffer, byteOffset } = frame;
    const record = new Uint8Array(buffer, byteOffset + start, byteLength);
    if (buffer.byteLength <= MAX_MEMORY * byteLength) return record;
    if (byteLength > SMALL_BYTES) return record.slice();
    if (this.#shared === undefined || this.#sharedLength + byteLength > SHARED_BYTES) {
      this.#shared = new ArrayBuffer(SHARED_BYTES);
      this.#sharedLength = 0;
    }
    const copy = new Uint8Array(this.#shared, this.#sharedLength, byteLength);
    copy.set(record);
    this.#sharedLength += byteLength;
    return copy;
  }
}
