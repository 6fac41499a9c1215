import {
  ALIGNMENT,
  entryBytes,
  FILLER,
  HEAD_BYTES,
  TARGET_BITS,
  TARGETS,
  type RingMemory,
  type RingSpan,
} from './shared-ring.ts';

/** Entries leave some at a time, so that a value that is followed by another one is not kept in between. */
const RELEASED_BYTES = 64 * 1024;
const WORD_BYTES = 4;
const DOUBLE_BYTES = 8;

/** What stands before a record. The caller may use one object for all. */
export interface EntryHead {
  readonly channel: number;
  readonly targets: number;
  readonly timeMs: number;
  readonly order: number;
}

/** An entry that leaves. One object for all, valid during the call. */
export interface ReleasedEntry {
  channel: number;
  targets: number;
  timeMs: number;
  /** Bytes of the record. */
  length: number;
  /** Where the entry begins, counted over all laps. */
  position: number;
  /** Where the record begins in memory. */
  offset: number;
}

/** Called with entries before they are overwritten. */
export interface ReleaseListener {
  release(entry: ReleasedEntry): void;
  /** The last entry of a group was announced: copy now what should stay. @param bytes of the ring */
  settle(bytes: Uint8Array<SharedArrayBuffer>): void;
}

/** Writes records into a ring. */
export class RingWriter {
  readonly memory: RingMemory;
  readonly #bytes: Uint8Array<SharedArrayBuffer>;
  readonly #words: Uint32Array<SharedArrayBuffer>;
  readonly #doubles: Float64Array<SharedArrayBuffer>;
  readonly #sharedTail: BigInt64Array<SharedArrayBuffer>;
  readonly #capacity: number;
  readonly #listener: ReleaseListener;
  readonly #released: ReleasedEntry = {
    channel: 0,
    targets: 0,
    timeMs: 0,
    length: 0,
    position: 0,
    offset: 0,
  };
  #head = 0;
  #tail = 0;
  #records = 0;

  /** @param capacity bytes, reserved and not touched before they are needed */
  constructor(capacity: number, listener: ReleaseListener) {
    this.#capacity = Math.floor(capacity / ALIGNMENT) * ALIGNMENT;
    this.#listener = listener;
    this.memory = {
      tail: new SharedArrayBuffer(BigInt64Array.BYTES_PER_ELEMENT),
      bytes: new SharedArrayBuffer(this.#capacity),
    };
    this.#bytes = new Uint8Array(this.memory.bytes);
    this.#words = new Uint32Array(this.memory.bytes);
    this.#doubles = new Float64Array(this.memory.bytes);
    this.#sharedTail = new BigInt64Array(this.memory.tail);
  }

  /** All entries. */
  get span(): RingSpan {
    return { from: this.#tail, to: this.#head };
  }

  get heldBytes(): number {
    return this.#head - this.#tail;
  }

  /** Records held; ends of topics aside. */
  get records(): number {
    return this.#records;
  }

  /** Time of the oldest entry, epoch milliseconds; undefined without entries. */
  get oldestMs(): number | undefined {
    this.#skipFiller();
    if (this.#tail === this.#head) return undefined;
    return this.#doubles[this.#offsetOf(this.#tail) / DOUBLE_BYTES + 2];
  }

  /**
   * Copies a record. The oldest ones leave where there is no room.
   *
   * @param bound bytes that may be held
   * @returns false when the record alone is larger than that
   */
  add(record: Uint8Array, head: EntryHead, bound: number): boolean {
    const { length } = record;
    // Memory that is shared between threads is copied word by word where both ends are aligned alike, and else byte by byte.
    const shift = record.byteOffset & (ALIGNMENT - 1);
    const size = entryBytes(shift, length);
    const most = bound < this.#capacity ? bound : this.#capacity;
    if (size > most) return false;
    const wanted = size + this.#restBefore(size);
    if (this.#head - this.#tail + wanted > most) this.limitTo(most - wanted);
    const rest = this.#restBefore(size);
    if (rest > 0) this.#skip(rest);
    const offset = this.#head % this.#capacity;
    const word = offset / WORD_BYTES;
    this.#words[word] = head.channel;
    this.#words[word + 1] = length;
    this.#words[word + 2] = head.targets | (shift << TARGET_BITS);
    this.#words[word + 3] = head.order;
    this.#doubles[offset / DOUBLE_BYTES + 2] = head.timeMs;
    if (length > 0) {
      this.#bytes.set(record, offset + HEAD_BYTES + shift);
      this.#records++;
    }
    this.#head += size;
    return true;
  }

  /** Lets the oldest entries leave until so many bytes are left at most. */
  limitTo(bytes: number): void {
    const until = this.#head - Math.max(0, bytes);
    if (this.#tail >= until) return;
    // More than is needed, so that the next records need nothing.
    const more = Math.min(RELEASED_BYTES, this.#capacity / ALIGNMENT);
    this.#releaseWhile((position) => position < until + more);
  }

  /**
   * Lets entries leave that are older than a moment, and overwrites them.
   *
   * @param maxBytes that leave at once, so that nothing else waits for it
   * @returns whether there are more
   */
  expire(beforeMs: number, maxBytes: number): boolean {
    const from = this.#tail;
    const isOver = (): boolean => (this.oldestMs ?? Infinity) < beforeMs;
    if (!isOver()) return false;
    const to = this.#releaseWhile((position) => position - from < maxBytes && isOver());
    this.#erase(from, to);
    return isOver();
  }

  #offsetOf(position: number): number {
    return position % this.#capacity;
  }

  /** @returns where the last one ended */
  #releaseWhile(isWanted: (position: number) => boolean): number {
    const released = this.#released;
    this.#skipFiller();
    while (this.#tail < this.#head && isWanted(this.#tail)) {
      const start = this.#offsetOf(this.#tail);
      const word = start / WORD_BYTES;
      const length = this.#words[word + 1]!;
      const packed = this.#words[word + 2]!;
      const shift = packed >>> TARGET_BITS;
      released.channel = this.#words[word]!;
      released.length = length;
      released.targets = packed & TARGETS;
      released.timeMs = this.#doubles[start / DOUBLE_BYTES + 2]!;
      released.position = this.#tail;
      released.offset = start + HEAD_BYTES + shift;
      if (length > 0) this.#records--;
      this.#listener.release(released);
      this.#tail += entryBytes(shift, length);
      this.#skipFiller();
    }
    this.#listener.settle(this.#bytes);
    const end = this.#tail;
    // Without entries it begins at the start: memory that was never needed stays untouched.
    if (this.#tail === this.#head) {
      this.#head = Math.ceil(this.#head / this.#capacity) * this.#capacity;
      this.#tail = this.#head;
    }
    // An exchange, unlike a store, also keeps what is written afterwards from being seen before it.
    Atomics.exchange(this.#sharedTail, 0, BigInt(this.#tail));
    return end;
  }

  /** Lets the oldest entry be one with a record or an end. */
  #skipFiller(): void {
    const offset = this.#offsetOf(this.#tail);
    const rest = this.#capacity - offset;
    if (this.#tail === this.#head) return;
    if (rest < HEAD_BYTES || this.#words[offset / WORD_BYTES] === FILLER) this.#tail += rest;
  }

  /** Bytes at the end of the lap that are too few for an entry. */
  #restBefore(size: number): number {
    const rest = this.#capacity - (this.#head % this.#capacity);
    return rest < size ? rest : 0;
  }

  #skip(bytes: number): void {
    if (bytes >= HEAD_BYTES) this.#words[this.#offsetOf(this.#head) / WORD_BYTES] = FILLER;
    this.#head += bytes;
  }

  #erase(from: number, to: number): void {
    const bytes = Math.min(to - from, this.#capacity);
    const start = this.#offsetOf(from);
    const end = Math.min(start + bytes, this.#capacity);
    this.#bytes.fill(0, start, end);
    this.#bytes.fill(0, 0, bytes - (end - start));
  }
}
