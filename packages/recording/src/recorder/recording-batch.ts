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
 * Copies records one after another into memory for a batch: a copy costs less than an object for each that outlives the
 * next garbage collection. A batch starts with the memory that the one before it needed.
 */
export class OpenBatch {
  #number = nextNumber++;
  #sources: RecordSource[] = [];
  #heads = new Float64Array(0);
  #bytes = new Uint8Array(0);
  #count = 0;
  #byteLength = 0;
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
    const end = this.#byteLength + byteLength;
    if (end > this.#bytes.length) this.#growBytes(end);
    this.#bytes.set(record, this.#byteLength);
    this.#byteLength = end;
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
    };
    this.#usualRecords = Math.max(MIN_RECORDS, this.#count);
    this.#usualBytes = Math.max(MIN_BYTES, this.#byteLength);
    this.#number = nextNumber++;
    this.#sources = [];
    this.#heads = new Float64Array(0);
    this.#bytes = new Uint8Array(0);
    this.#count = 0;
    this.#byteLength = 0;
    this.#targets = 0;
    return batch;
  }

  #growHeads(): void {
    const heads = new Float64Array(Math.max(this.#usualRecords * NUMBERS, this.#heads.length * 2));
    heads.set(this.#heads);
    this.#heads = heads;
  }

  #growBytes(atLeast: number): void {
    const bytes = new Uint8Array(Math.max(this.#usualBytes, this.#bytes.length * 2, atLeast));
    bytes.set(this.#bytes.subarray(0, this.#byteLength));
    this.#bytes = bytes;
  }
}

/** The records of a batch; their bytes are views of it. */
export function recordsOf({ count, sources, heads, bytes }: RecordingBatch): RecordToKeep[] {
  let offset = 0;
  const records: RecordToKeep[] = [];
  for (let at = 0; at < count * NUMBERS; at += NUMBERS) {
    const start = offset;
    offset += heads[at + 2]!;
    const record = bytes.subarray(start, offset);
    const source = sources[heads[at]!]!;
    records.push({ source, record, timeMs: heads[at + 3]!, targets: heads[at + 1]! });
  }
  return records;
}
