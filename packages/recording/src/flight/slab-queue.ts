import type { RecordedRecord } from '../records/recorded-record.ts';
import { isEnd, JoinedSlab, SingleSlab, slabBytesOf, type Slab, type SlabEntry } from './slab.ts';

/** Slabs of one size class; the oldest leaves first. */
export class SlabQueue {
  readonly #slabs: Slab[] = [];
  /** The last one, where it may have room for more. */
  #open: JoinedSlab | undefined = undefined;
  #bytes = 0;
  #records = 0;

  get bytes(): number {
    return this.#bytes;
  }

  get records(): number {
    return this.#records;
  }

  get oldest(): Slab | undefined {
    return this.#slabs[0];
  }

  /** Copies a record. @param slabBytes of a new slab; a record that is larger gets one of its own size */
  add(channel: number, record: RecordedRecord, slabBytes: number): void {
    if (this.#open?.hasRoomFor(record.record) !== true) {
      this.#open = new JoinedSlab(Math.max(slabBytes, slabBytesOf(record.record)));
      this.#push(this.#open);
    }
    this.#open.add(channel, record);
    if (!isEnd(record.record)) this.#records++;
  }

  /** Keeps a record where it lies, unless it shares its memory with others. */
  keep(channel: number, record: RecordedRecord): void {
    this.#open = undefined;
    this.#push(new SingleSlab(channel, record));
    this.#records++;
  }

  /** Takes out the oldest slab. */
  shift(): Slab | undefined {
    const slab = this.#slabs.shift();
    if (slab === this.#open) this.#open = undefined;
    this.#bytes -= slab?.byteLength ?? 0;
    this.#records -= slab?.records ?? 0;
    return slab;
  }

  /** The records as they are now, in the order in which they came. */
  entries(): Iterable<SlabEntry> {
    return chained(this.#slabs.map((slab) => slab.entries()));
  }

  #push(slab: Slab): void {
    this.#slabs.push(slab);
    this.#bytes += slab.byteLength;
  }
}

function* chained(parts: readonly Iterable<SlabEntry>[]): Generator<SlabEntry> {
  for (const part of parts) yield* part;
}
