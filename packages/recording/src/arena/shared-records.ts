import { RingReader, type RingEntry, type RingMemory, type RingSpan } from './shared-ring.ts';

/** Bit of the flight recorder in the targets of a record. */
export const FLIGHT_TARGET = 1;

/** Memory with records, for threads: small and large ones. */
export interface SharedRecords {
  readonly small: RingMemory;
  readonly large: RingMemory;
}

/** From where to where to read. */
export interface RecordSpans {
  readonly small: RingSpan;
  readonly large: RingSpan;
}

/** What is behind `read`. */
export function spansFrom(all: RecordSpans, read: RecordSpans): RecordSpans {
  const after = (span: RingSpan, before: RingSpan): RingSpan => ({
    from: Math.max(span.from, before.to),
    to: span.to,
  });
  return { small: after(all.small, read.small), large: after(all.large, read.large) };
}

/** Reads records that another thread writes, in the order in which they were written. */
export class SharedReader {
  readonly #small: RingReader;
  readonly #large: RingReader;

  /** @param blockBytes copied at once: the more, the less is overwritten meanwhile */
  constructor({ small, large }: SharedRecords, blockBytes?: number) {
    this.#small = new RingReader(small, blockBytes);
    this.#large = new RingReader(large, blockBytes);
  }

  /** Small and large ones, one after the other. */
  read({ small, large }: RecordSpans): Iterable<RingEntry> {
    return inOrder(this.#small.read(small), this.#large.read(large));
  }
}

function* inOrder(
  first: Generator<RingEntry>,
  second: Generator<RingEntry>,
): Generator<RingEntry, void> {
  let a = first.next();
  let b = second.next();
  while (a.done !== true && b.done !== true) {
    if (isBefore(a.value, b.value)) {
      yield a.value;
      a = first.next();
    } else {
      yield b.value;
      b = second.next();
    }
  }
  if (a.done !== true) {
    yield a.value;
    yield* first;
  }
  if (b.done !== true) {
    yield b.value;
    yield* second;
  }
}

/** The order begins again after 2^32 entries; fewer are held. */
function isBefore(a: RingEntry, b: RingEntry): boolean {
  return ((a.order - b.order) | 0) < 0;
}

/** Overwrites all of it. */
export function erase({ small, large }: SharedRecords): void {
  for (const { bytes } of [small, large]) new Uint8Array(bytes).fill(0);
}
