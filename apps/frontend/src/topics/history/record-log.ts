import type { DataFormat, TopicRecord } from '@ubii/proto';
import { formatValue } from '../values/format-value.ts';
import { valueBytes } from '../values/value-bytes.ts';

/** A record in the history. */
export interface KeptRecord {
  /** Sequence number of the record since the topic was opened, from 1; 0 and less for those before. */
  readonly number: number;
  /** Timestamp of the publisher, epoch milliseconds; `undefined` without one. */
  readonly timestampMs: number | undefined;
  /** Time of arrival, this computer's clock. */
  readonly arrivalMs: number;
  /** Estimated time of measurement, this computer's clock. */
  readonly localMs: number;
  readonly format: DataFormat;
  /** `undefined` for values that are too large to keep: pictures and long texts. */
  readonly value: unknown;
  /** Text of a value that is not kept, in one line. */
  readonly line: string | undefined;
  readonly clientId: string;
  readonly bytes: number;
}

/** Largest value that is kept, bytes; of larger ones only the text in one line. */
export const MAX_VALUE_BYTES = 16_384;
/** Estimated memory of a record without its value, bytes. */
const OVERHEAD_BYTES = 160;

/** The newest records of a topic within a memory limit. */
export class RecordLog {
  /** Oldest first, from `#start`; the unused part before it is removed from time to time. */
  #entries: KeptRecord[] = [];
  #start = 0;
  #count: number;
  #bytes = 0;

  /** @param before records that come before number 1: theirs are 0 and less */
  constructor(before = 0) {
    this.#count = -before;
  }

  /** Number of the newest record. */
  get count(): number {
    return this.#count;
  }

  get size(): number {
    return this.#entries.length - this.#start;
  }

  /** Number of the oldest record kept; `count + 1` when there is none. */
  get firstNumber(): number {
    return this.#count - this.size + 1;
  }

  get bytes(): number {
    return this.#bytes;
  }

  get oldest(): KeptRecord | undefined {
    return this.#entries[this.#start];
  }

  /** All that are kept, oldest first. */
  kept(): readonly KeptRecord[] {
    return this.#entries.slice(this.#start);
  }

  at(number: number): KeptRecord | undefined {
    const index = number - this.firstNumber;
    return index < 0 ? undefined : this.#entries[this.#start + index];
  }

  add(
    { format, value, timestampMs, clientId }: TopicRecord,
    arrivalMs: number,
    localMs: number,
    { maxBytes, sinceMs }: { readonly maxBytes: number; readonly sinceMs: number },
  ): void {
    const size = valueBytes(value, MAX_VALUE_BYTES);
    const isKept = size <= MAX_VALUE_BYTES;
    const line = isKept ? undefined : formatValue(format, value as never);
    const bytes = OVERHEAD_BYTES + (isKept ? size : 2 * line!.length);
    this.#count += 1;
    this.#entries.push({
      number: this.#count,
      timestampMs,
      arrivalMs,
      localMs,
      format,
      value: isKept ? value : undefined,
      line,
      clientId,
      bytes,
    });
    this.#bytes += bytes;
    while (this.size > 1 && (this.#bytes > maxBytes || this.oldest!.localMs < sinceMs)) {
      this.#bytes -= this.oldest!.bytes;
      this.#start += 1;
    }
    if (this.#start > 1024 && this.#start > this.size) {
      this.#entries = this.#entries.slice(this.#start);
      this.#start = 0;
    }
  }

  /** Returns the record nearest to a time of this computer's clock, up to a number. */
  nearest(localMs: number, upTo = this.#count): KeptRecord | undefined {
    let [low, high] = [this.firstNumber, Math.min(upTo, this.#count)];
    if (low > high) return undefined;
    while (low < high) {
      const middle = (low + high) >>> 1;
      if (this.at(middle)!.localMs < localMs) low = middle + 1;
      else high = middle;
    }
    const [before, after] = [this.at(low - 1), this.at(low)];
    if (!before || !after) return after ?? before;
    return localMs - before.localMs < after.localMs - localMs ? before : after;
  }
}
