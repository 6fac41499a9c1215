import type { RecordedRecord } from '../records/recorded-record.ts';
import { isEnd, Slab, slabBytesOf, type SlabEntry } from './slab.ts';

/** Slabs of one size class; the oldest leaves first. */
export class SlabQueue {
  readonly #slabs: Slab[] = [];
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

  /** @param slabBytes of a new slab; a record that is larger gets one of its own size */
  add(channel: number, record: RecordedRecord, slabBytes: number): void {
    let slab = this.#slabs.at(-1);
    if (slab === undefined || !slab.hasRoomFor(record.record)) {
      slab = new Slab(Math.max(slabBytes, slabBytesOf(record.record)));
      this.#slabs.push(slab);
      this.#bytes += slab.byteLength;
    }
    slab.add(channel, record);
    if (!isEnd(record.record)) this.#records++;
  }

  /** Takes out the oldest slab. */
  shift(): Slab | undefined {
    const slab = this.#slabs.shift();
    this.#bytes -= slab?.byteLength ?? 0;
    this.#records -= slab?.records ?? 0;
    return slab;
  }

  /** The records as they are now, in the order in which they came. */
  entries(): Iterable<SlabEntry> {
    return chained(this.#slabs.map((slab) => slab.entries()));
  }
}

function* chained(parts: readonly Iterable<SlabEntry>[]): Generator<SlabEntry> {
  for (const part of parts) yield* part;
}
