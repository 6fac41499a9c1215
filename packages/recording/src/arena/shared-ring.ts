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
