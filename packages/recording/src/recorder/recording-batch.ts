import { MAX_JOINED_BYTES } from '../records/large-record.ts';
import type { RecordingBatch, RecordSource, RecordToKeep } from './recorder.ts';

/** A source that knows its place in the batch that is open. */
export interface BatchedSource extends RecordSource {
  /** Number of the batch that it was in last. */
  batchNumber: number;
  /** Its place among the sources of that batch. */
  place: number;
}

/** Numbers of each record in `RecordingBatch.heads`. */
const NUMBERS = 4;
const MIN_RECORDS = 16;
const MIN_BYTES = 2048;

let nextNumber = 0;

/**
 * Copies records into memory for a batch, small ones one after another: a copy costs less than an object for each that
 * outlives the next garbage collection. A batch starts with the memory that the one before it needed.
 */
export class OpenBatch {
  #number = nextNumber++;
  #sources: RecordSource[] = [];
  #heads = new Float64Array(0);
  #bytes = new Uint8Array(0);
  #large: Uint8Array<ArrayBuffer>[] = [];
  #count = 0;
  /** Bytes of all records, and of those that are joined. */
  #byteLength = 0;
  #joinedLength = 0;
  #targets = 0;
  /** What the last batch needed. */
  #usualRecords = MIN_RECORDS;
  #usualBytes = MIN_BYTES;

  get count(): number {
    return this.#count;
  }

  /** Bytes of the records. */
  get byteLength(): number {
    return this.#byteLength;
  }

  /** @param timeMs epoch milliseconds */
  add(source: BatchedSource, record: Uint8Array, timeMs: number, targets: number): void {
    if (source.batchNumber !== this.#number) {
      source.batchNumber = this.#number;
      source.place = this.#sources.push(source) - 1;
    }
    this.#targets |= targets;
    const { byteLength } = record;
    const at = this.#count++ * NUMBERS;
    if (at === this.#heads.length) this.#growHeads();
    const heads = this.#heads;
    heads[at] = source.place;
    heads[at + 1] = targets;
    heads[at + 2] = byteLength;
    heads[at + 3] = timeMs;
    this.#byteLength += byteLength;
    if (byteLength > MAX_JOINED_BYTES) this.#large.push(new Uint8Array(record));
    else this.#join(record);
  }

  /** Returns what was added; the next batch begins. */
  take(): RecordingBatch {
    const batch = {
      count: this.#count,
      targets: this.#targets,
      byteLength: this.#byteLength,
      sources: this.#sources,
      heads: this.#heads,
      bytes: this.#bytes,
      large: this.#large,
    };
    this.#usualRecords = Math.max(MIN_RECORDS, this.#count);
    this.#usualBytes = Math.max(MIN_BYTES, this.#joinedLength);
    this.#number = nextNumber++;
    this.#sources = [];
    this.#heads = new Float64Array(0);
    this.#bytes = new Uint8Array(0);
    this.#large = [];
    this.#count = 0;
    this.#byteLength = 0;
    this.#joinedLength = 0;
    this.#targets = 0;
    return batch;
  }

  #join(record: Uint8Array): void {
    const end = this.#joinedLength + record.byteLength;
    if (end > this.#bytes.length) this.#growBytes(end);
    this.#bytes.set(record, this.#joinedLength);
    this.#joinedLength = end;
  }

  #growHeads(): void {
    const heads = new Float64Array(Math.max(this.#usualRecords * NUMBERS, this.#heads.length * 2));
    heads.set(this.#heads);
    this.#heads = heads;
  }

  #growBytes(atLeast: number): void {
    const bytes = new Uint8Array(Math.max(this.#usualBytes, this.#bytes.length * 2, atLeast));
    bytes.set(this.#bytes.subarray(0, this.#joinedLength));
    this.#bytes = bytes;
  }
}

/** The records of a batch. The bytes of small ones are views of it; those of large ones are in memory of their own. */
export function recordsOf({ count, sources, heads, bytes, large }: RecordingBatch): RecordToKeep[] {
  let offset = 0;
  let nextLarge = 0;
  const records: RecordToKeep[] = [];
  for (let at = 0; at < count * NUMBERS; at += NUMBERS) {
    const byteLength = heads[at + 2]!;
    const isLarge = byteLength > MAX_JOINED_BYTES;
    const record = isLarge ? large[nextLarge++]! : bytes.subarray(offset, offset + byteLength);
    if (!isLarge) offset += byteLength;
    const source = sources[heads[at]!]!;
    records.push({ source, record, timeMs: heads[at + 3]!, targets: heads[at + 1]! });
  }
  return records;
}
