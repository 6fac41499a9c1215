import type { RecordsReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';

/** Reading stops when so much was read ahead. */
const MAX_RECORDS = 4_000;
const MAX_BYTES = 16 * 1024 * 1024;

/** What a feed reads. */
export interface FeedOptions {
  readonly reader: RecordsReader;
  /** First time, inclusive. */
  readonly fromNs: bigint;
  /** Last time, inclusive. */
  readonly untilNs: bigint;
  /** Bytes read ahead. @default 16 MiB */
  readonly maxBytes?: number | undefined;
  onError(error: unknown): void;
}

/** Records that were due. */
export interface DueRecords {
  readonly records: readonly RecordedRecord[];
  /** Nothing is missing up to here: less than what was asked for when reading is behind. */
  readonly reachedNs: bigint;
}

/** Reads records ahead of the playhead. */
export class RecordFeed {
  readonly #iterator: AsyncIterator<RecordedRecord>;
  readonly #onError: (error: unknown) => void;
  readonly #maxBytes: number;
  #queue: RecordedRecord[] = [];
  #bytes = 0;
  #reachedNs: bigint;
  #isDone = false;
  #isReading = false;
  #isClosed = false;

  constructor({ reader, fromNs, untilNs, maxBytes = MAX_BYTES, onError }: FeedOptions) {
    this.#iterator = reader.records({ fromNs, untilNs })[Symbol.asyncIterator]();
    this.#reachedNs = fromNs - 1n;
    this.#onError = onError;
    this.#maxBytes = maxBytes;
    void this.#readAhead();
  }

  /** Takes records up to a time, inclusive. */
  take(untilNs: bigint): DueRecords {
    const later = this.#queue.findIndex(({ logTimeNs }) => logTimeNs > untilNs);
    let count = later < 0 ? this.#queue.length : later;
    this.#reachedNs = later >= 0 || this.#isDone ? untilNs : this.#reachedNs;
    if (later < 0 && !this.#isDone && count > 0) {
      // Reading is behind. There may be more records of the last time: they stay together.
      const lastNs = this.#queue[count - 1]!.logTimeNs;
      count = this.#isFull ? count : this.#queue.findIndex(({ logTimeNs }) => logTimeNs === lastNs);
      this.#reachedNs = this.#isFull ? lastNs : lastNs - 1n;
    }
    const records = this.#queue.splice(0, count);
    for (const { record } of records) this.#bytes -= record.length;
    void this.#readAhead();
    return { records, reachedNs: this.#reachedNs };
  }

  close(): void {
    this.#isClosed = true;
    this.#queue = [];
  }

  get #isFull(): boolean {
    return this.#queue.length >= MAX_RECORDS || this.#bytes >= this.#maxBytes;
  }

  async #readAhead(): Promise<void> {
    if (this.#isReading || this.#isDone) return;
    this.#isReading = true;
    try {
      while (!this.#isFull) {
        const next = await this.#iterator.next();
        if (this.#isClosed) return;
        if (next.done === true) {
          this.#isDone = true;
          return;
        }
        this.#queue.push(next.value);
        this.#bytes += next.value.record.length;
      }
    } catch (error) {
      if (!this.#isClosed) this.#onError(error);
    } finally {
      this.#isReading = false;
    }
  }
}
