/*
 * Memory that a thread writes records into and others read, without a message or an object for a record. The newest overwrites the
 * oldest: a reader copies first, and looks afterwards whether what it copied was overwritten meanwhile.
 *
 * An entry begins at a multiple of 8 bytes with four numbers of 32 bits (channel, bytes of the record, targets and where in a
 * multiple of 8 the record begins, order) and the time in milliseconds as a double. The record follows. A rest at the end of the memory that is
 * too short for the next entry has the channel `FILLER`, or has no head where there is no room for one. Positions count on
 * over all laps; the place in memory is their remainder.
 */

/** Bytes before each record. */
export const HEAD_BYTES = 24;
/** Entries and laps begin at multiples of it, and so do words that are copied at once. */
export const ALIGNMENT = 8;
/** Channel of an entry without a record. */
export const FILLER = 0xffff_ffff;
/** Targets are the lower bits of a number, the place of the record within 8 bytes those above. */
export const TARGET_BITS = 16;
export const TARGETS = 0xffff;

/** Memory of a ring, for threads. */
export interface RingMemory {
  /** Position of the oldest entry that is not overwritten, as one integer of 64 bits. */
  readonly tail: SharedArrayBuffer;
  readonly bytes: SharedArrayBuffer;
}

/** Where entries begin and end. */
export interface RingSpan {
  readonly from: number;
  readonly to: number;
}

/** An entry as it stands in a ring. */
export interface RingEntry {
  readonly channel: number;
  readonly targets: number;
  /** Grows by one with each entry, over several rings; begins again after 2^32. */
  readonly order: number;
  /** Epoch milliseconds. */
  readonly timeMs: number;
  /** A view, valid until the next entry is read; empty where a topic lost its value. */
  readonly record: Uint8Array<ArrayBuffer>;
}

/** Bytes that a record takes, with what is before and behind it. */
export function entryBytes(shift: number, length: number): number {
  return (HEAD_BYTES + shift + length + ALIGNMENT - 1) & -ALIGNMENT;
}

/** Copied at once by default, unless an entry is larger. */
const BLOCK_BYTES = 256 * 1024;
const WORD_BYTES = 4;
const DOUBLE_BYTES = 8;

/** Bytes of a ring that were not overwritten while they were copied. */
interface Block {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Position of its first byte. */
  readonly from: number;
}

/** Reads what another thread writes into a ring. */
export class RingReader {
  readonly #bytes: Uint8Array<SharedArrayBuffer>;
  readonly #words: Uint32Array<SharedArrayBuffer>;
  readonly #sharedTail: BigInt64Array<SharedArrayBuffer>;
  readonly #capacity: number;
  readonly #blockBytes: number;

  /** @param blockBytes copied at once: the more, the less is overwritten meanwhile */
  constructor({ tail, bytes }: RingMemory, blockBytes = BLOCK_BYTES) {
    this.#blockBytes = blockBytes;
    this.#bytes = new Uint8Array(bytes);
    this.#words = new Uint32Array(bytes);
    this.#sharedTail = new BigInt64Array(tail);
    this.#capacity = bytes.byteLength;
  }

  /** Entries in the order in which they came; those that were overwritten are missing. */
  *read({ from, to }: RingSpan): Generator<RingEntry> {
    for (let at = this.#begin(from); at < to;) {
      const rest = this.#capacity - (at % this.#capacity);
      if (rest < HEAD_BYTES) {
        at += rest;
        continue;
      }
      const block = this.#copy(at, Math.min(rest, to - at));
      if (block.from > at) at = block.from;
      else at = yield* this.#entriesOf(block);
      at = this.#begin(at);
    }
  }

  /** Position where reading continues: at the oldest entry when earlier ones were overwritten. */
  #begin(position: number): number {
    const tail = this.#tail();
    return position < tail ? tail : position;
  }

  /** Earlier reads happened before the read of the tail. */
  #tail(): number {
    return Number(Atomics.add(this.#sharedTail, 0, 0n));
  }

  /** Copies whole entries from a position on, up to `most` bytes. Begins later when what it copied was overwritten. */
  #copy(position: number, most: number): Block {
    const start = position % this.#capacity;
    const bytes = Math.min(most, Math.max(this.#blockBytes, this.#sizeAt(start)));
    const copy = this.#bytes.slice(start, start + bytes);
    return { bytes: copy, from: Math.max(position, this.#tail()) };
  }

  #sizeAt(offset: number): number {
    const word = offset / WORD_BYTES;
    if (this.#words[word] === FILLER) return HEAD_BYTES;
    return entryBytes(this.#words[word + 2]! >>> TARGET_BITS, this.#words[word + 1]!);
  }

  /** @returns position of the first entry that is not whole in the block */
  *#entriesOf({ bytes, from }: Block): Generator<RingEntry, number> {
    const { buffer } = bytes;
    const words = new Uint32Array(buffer, 0, Math.floor(buffer.byteLength / WORD_BYTES));
    const doubles = new Float64Array(buffer, 0, Math.floor(buffer.byteLength / DOUBLE_BYTES));
    let at = 0;
    while (at + HEAD_BYTES <= bytes.length) {
      const word = at / WORD_BYTES;
      const channel = words[word]!;
      if (channel === FILLER) {
        const position = from + at;
        return position + this.#capacity - (position % this.#capacity);
      }
      const length = words[word + 1]!;
      const packed = words[word + 2]!;
      const shift = packed >>> TARGET_BITS;
      const end = at + entryBytes(shift, length);
      if (end > bytes.length) break;
      const start = at + HEAD_BYTES + shift;
      yield {
        channel,
        targets: packed & TARGETS,
        order: words[word + 3]!,
        timeMs: doubles[at / DOUBLE_BYTES + 2]!,
        record: bytes.subarray(start, start + length),
      };
      at = end;
    }
    return from + at;
  }
}
