import type { RecordedRecord } from '../records/recorded-record.ts';

/** Bytes before each record: channel, length, log time, publish time. */
const HEAD_BYTES = 24;

/** Topic and publisher of records in slabs, which hold its number. */
export interface SlabChannel {
  readonly topic: string;
  readonly clientId: string;
}

/** A record in a slab, with the number of its channel. */
export type SlabEntry = readonly [number, Omit<RecordedRecord, keyof SlabChannel>];

/** Memory that a record takes in a slab, bytes. */
export function slabBytesOf(record: Uint8Array): number {
  return HEAD_BYTES + record.length;
}

/** Whether an entry says that its topic lost its value: it is in place of a record, and empty. */
export function isEnd(record: Uint8Array): boolean {
  return record.length === 0;
}

/** Memory with records, which leaves as a whole. */
export interface Slab {
  /** Memory that it takes, always. */
  readonly byteLength: number;
  /** Number of records, ends of topics aside. */
  readonly records: number;
  /** Log time of the oldest record; undefined without records. */
  readonly oldestNs: bigint | undefined;
  /** Log time of the newest record. */
  readonly newestNs: bigint;
  /** The records that it has now, with the numbers of their channels; bytes are views. */
  entries(): Iterable<SlabEntry>;
}

/** Records one behind the other in one piece of memory: a small record costs 24 bytes, and the collector nothing. */
export class JoinedSlab implements Slab {
  readonly #bytes: Uint8Array;
  readonly #view: DataView;
  #end = 0;
  #records = 0;
  #oldestNs: bigint | undefined;
  #newestNs = 0n;

  /** @param bytes of memory that it takes, always */
  constructor(bytes: number) {
    this.#bytes = new Uint8Array(bytes);
    this.#view = new DataView(this.#bytes.buffer);
  }

  get byteLength(): number {
    return this.#bytes.length;
  }

  get records(): number {
    return this.#records;
  }

  get oldestNs(): bigint | undefined {
    return this.#oldestNs;
  }

  get newestNs(): bigint {
    return this.#newestNs;
  }

  hasRoomFor(record: Uint8Array): boolean {
    return this.#end + slabBytesOf(record) <= this.#bytes.length;
  }

  add(channel: number, { record, logTimeNs, publishTimeNs }: RecordedRecord): void {
    const at = this.#end;
    this.#view.setUint32(at, channel);
    this.#view.setUint32(at + 4, record.length);
    this.#view.setBigUint64(at + 8, logTimeNs);
    this.#view.setBigUint64(at + 16, publishTimeNs);
    this.#bytes.set(record, at + HEAD_BYTES);
    this.#end += slabBytesOf(record);
    if (!isEnd(record)) this.#records++;
    if (logTimeNs > this.#newestNs) this.#newestNs = logTimeNs;
    if (this.#oldestNs === undefined || logTimeNs < this.#oldestNs) this.#oldestNs = logTimeNs;
  }

  *entries(until = this.#end): Generator<SlabEntry> {
    for (let at = 0; at < until;) {
      const start = at + HEAD_BYTES;
      const end = start + this.#view.getUint32(at + 4);
      const logTimeNs = this.#view.getBigUint64(at + 8);
      const publishTimeNs = this.#view.getBigUint64(at + 16);
      const record = this.#bytes.subarray(start, end);
      yield [this.#view.getUint32(at), { record, logTimeNs, publishTimeNs }];
      at = end;
    }
  }
}

/** One large record, where it lies: copies of pictures, and memory for them, are what pictures cost. */
export class SingleSlab implements Slab {
  readonly records = 1;
  readonly #entry: SlabEntry;

  constructor(channel: number, { record, logTimeNs, publishTimeNs }: RecordedRecord) {
    // A view would keep the memory of others as well.
    const isAlone = record.buffer.byteLength === record.byteLength;
    const own = isAlone ? record : new Uint8Array(record);
    this.#entry = [channel, { record: own, logTimeNs, publishTimeNs }];
  }

  get byteLength(): number {
    return slabBytesOf(this.#entry[1].record);
  }

  get oldestNs(): bigint {
    return this.#entry[1].logTimeNs;
  }

  get newestNs(): bigint {
    return this.#entry[1].logTimeNs;
  }

  entries(): Iterable<SlabEntry> {
    return [this.#entry];
  }
}
