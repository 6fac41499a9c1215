/** The exhausted memory: that of the owner of an instance, or that of all instances. */
export type MemoryShortage = 'owner' | 'all';

/** Of WebAssembly, bytes. */
export const PAGE_BYTES = 65_536;

/** Owners whose memory is counted at once; a master knows 1024 sessions. */
export const MAX_OWNERS = 4_096;

/**
 * Memory of instances in pages, as workers see it: shared by all workers where the platform supports it, else that of one worker.
 */
export interface MemoryCells {
  /** Limits, what all instances have, and what those of each owner have. */
  readonly counts: Int32Array;
  /** Memory of the instances of this worker by owner, freed when the worker ends. */
  readonly own: Int32Array;
}

const ALL_LIMIT = 0;
const OWNER_LIMIT = 1;
const ALL = 2;
const FIRST_OWNER = 3;

/** @param limits pages of all instances, and of those of one owner */
export function createMemoryCounts(
  limits: { readonly all: number; readonly owner: number },
  buffer: (bytes: number) => ArrayBufferLike,
): Int32Array {
  const counts = new Int32Array(buffer((FIRST_OWNER + MAX_OWNERS) * Int32Array.BYTES_PER_ELEMENT));
  counts[ALL_LIMIT] = limits.all;
  counts[OWNER_LIMIT] = limits.owner;
  return counts;
}

/** Takes pages for instances, and gives them back. Exact however many workers do so at once. [PM-58] */
export class MemoryAccount {
  readonly #cells: MemoryCells;

  constructor(cells: MemoryCells) {
    this.#cells = cells;
  }

  /** @returns whose memory does not suffice; nothing is taken then */
  take(owner: number, pages: number): MemoryShortage | undefined {
    const { counts, own } = this.#cells;
    if (Atomics.add(counts, ALL, pages) + pages > counts[ALL_LIMIT]!) {
      Atomics.sub(counts, ALL, pages);
      return 'all';
    }
    if (Atomics.add(counts, FIRST_OWNER + owner, pages) + pages > counts[OWNER_LIMIT]!) {
      Atomics.sub(counts, FIRST_OWNER + owner, pages);
      Atomics.sub(counts, ALL, pages);
      return 'owner';
    }
    Atomics.add(own, owner, pages);
    return undefined;
  }

  give(owner: number, pages: number): void {
    const { counts, own } = this.#cells;
    Atomics.sub(own, owner, pages);
    Atomics.sub(counts, FIRST_OWNER + owner, pages);
    Atomics.sub(counts, ALL, pages);
  }

  /** Megabytes of the limit that is meant. */
  limitMegabytes(shortage: MemoryShortage): number {
    const pages = this.#cells.counts[shortage === 'all' ? ALL_LIMIT : OWNER_LIMIT]!;
    return Math.round((pages * PAGE_BYTES) / 1024 / 1024);
  }
}

/** Gives back what the instances of a worker had that has ended. */
export function giveBackAll({ counts, own }: MemoryCells): void {
  for (let owner = 0; owner < own.length; owner++) {
    const pages = Atomics.exchange(own, owner, 0);
    if (pages === 0) continue;
    Atomics.sub(counts, FIRST_OWNER + owner, pages);
    Atomics.sub(counts, ALL, pages);
  }
}

/** Pages that instances of an owner have. */
export function pagesOf(counts: Int32Array, owner: number): number {
  return Atomics.load(counts, FIRST_OWNER + owner);
}
