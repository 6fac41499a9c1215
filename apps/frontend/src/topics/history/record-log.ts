import type { DataFormat, TopicRecord } from '@ubii/proto';
import { formatValue } from '../values/format-value.ts';
import { valueBytes } from '../values/value-bytes.ts';

/** A record that was kept. */
export interface KeptRecord {
  /** Counts up from 1 with every record of the topic seen here. */
  readonly number: number;
  /** The publisher's clock: milliseconds since the Unix epoch; `undefined` when it does not say. */
  readonly timestampMs: number | undefined;
  /** When it came here, this machine's clock. */
  readonly arrivalMs: number;
  /** When the value was taken, as well as can be told, this machine's clock. */
  readonly localMs: number;
  readonly format: DataFormat;
  /** `undefined` for what is too large to keep: pictures and long texts. */
  readonly value: unknown;
  /** The one line of a value that is not kept. */
  readonly line: string | undefined;
  readonly clientId: string;
  readonly bytes: number;
}

/** Larger values are not kept, only their one line, bytes. */
export const MAX_VALUE_BYTES = 16_384;
/** What a record needs beside its value, bytes, about. */
const OVERHEAD_BYTES = 160;

/** The newest records of a topic within a memory. */
export class RecordLog {
  /** Oldest first, from `#start` on; the part before it is cut off now and then. */
  #entries: KeptRecord[] = [];
  #start = 0;
  #count = 0;
  #bytes = 0;

  /** Records ever added; the newest has this number. */
  get count(): number {
    return this.#count;
  }

  get size(): number {
    return this.#entries.length - this.#start;
  }

  /** Of the oldest record kept; `count + 1` when none is. */
  get firstNumber(): number {
    return this.#count - this.size + 1;
  }

  get bytes(): number {
    return this.#bytes;
  }

  get oldest(): KeptRecord | undefined {
    return this.#entries[this.#start];
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

  /** The record nearest to a moment, this machine's clock, up to a number. */
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
