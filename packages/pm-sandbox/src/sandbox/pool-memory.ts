import type { SandboxMemory } from '../ports/sandbox.ts';
import {
  createMemoryCounts,
  giveBackAll,
  MAX_OWNERS,
  PAGE_BYTES,
  pagesOf,
  type MemoryCells,
} from '../worker/memory-account.ts';
import { MIN_MODULE_BYTES } from '../worker/quickjs/engine-pages.ts';

/** Memory of one instance. */
export interface MemoryUse {
  /** Number of its owner, for workers. */
  readonly number: number;
  /** @param bytes what it has now */
  note(bytes: number): void;
  /** It has nothing any more. */
  leave(): void;
}

/** Memory limits of a pool. */
export interface PoolMemoryOptions {
  /** Bytes of all sandboxed instances. */
  readonly limitBytes: number;
  /** Bytes of the sandboxed instances of one owner. */
  readonly ownerLimitBytes: number;
  /**
   * Workers that have to do with a part of that each, because they cannot see what the others have;
   * undefined: all see the same.
   */
  readonly parts: number | undefined;
}

interface Owner {
  readonly number: number;
  instances: number;
  bytes: number;
}

/** Key of instances without a session, and of those that do not fit into the table. */
const SHARED_NUMBER = 0;

/** Counts the memory of the instances of a pool: for workers, who take it, and for people. [PM-58] */
export class PoolMemory implements SandboxMemory {
  readonly #options: PoolMemoryOptions;
  readonly #owners = new Map<string, Owner>();
  readonly #freeNumbers: number[] = [];
  readonly #counts: Int32Array | undefined;
  #lastNumber = SHARED_NUMBER;
  #usedBytes = 0;

  constructor(options: PoolMemoryOptions) {
    this.#options = options;
    this.#counts = options.parts === undefined ? this.#createCounts() : undefined;
  }

  get limitBytes(): number {
    return this.#options.limitBytes;
  }

  get ownerLimitBytes(): number {
    return this.#options.ownerLimitBytes;
  }

  get leastBytes(): number {
    return MIN_MODULE_BYTES;
  }

  usedBytes(owner?: string): number {
    return owner === undefined ? this.#usedBytes : (this.#owners.get(owner)?.bytes ?? 0);
  }

  /** An instance comes. */
  enter(name: string): MemoryUse {
    const owner = this.#owners.get(name) ?? this.#add(name);
    owner.instances++;
    let bytes = 0;
    const note = (now: number): void => {
      owner.bytes += now - bytes;
      this.#usedBytes += now - bytes;
      bytes = now;
    };
    let isGone = false;
    return {
      number: owner.number,
      note: (now) => {
        if (!isGone) note(now);
      },
      leave: () => {
        if (isGone) return;
        note(0);
        isGone = true;
        owner.instances--;
        if (owner.instances === 0) this.#remove(name, owner);
      },
    };
  }

  /** A worker comes. */
  addWorker(): MemoryCells {
    const own = new Int32Array(this.#buffer(MAX_OWNERS * Int32Array.BYTES_PER_ELEMENT));
    return { counts: this.#counts ?? this.#createCounts(), own };
  }

  /** A worker is gone, with all that its instances had. */
  removeWorker(cells: MemoryCells): void {
    if (this.#counts !== undefined) giveBackAll(cells);
  }

  #add(name: string): Owner {
    const owner = { number: this.#newNumber(), instances: 0, bytes: 0 };
    this.#owners.set(name, owner);
    return owner;
  }

  #remove(name: string, { number }: Owner): void {
    this.#owners.delete(name);
    if (number !== SHARED_NUMBER) this.#freeNumbers.push(number);
  }

  /** Its instances may still have something in their workers: the oldest comes first. */
  #newNumber(): number {
    if (this.#lastNumber < MAX_OWNERS - 1) return ++this.#lastNumber;
    const counts = this.#counts;
    const index = this.#freeNumbers.findIndex(
      (number) => counts === undefined || pagesOf(counts, number) === 0,
    );
    return this.#freeNumbers.splice(index, index === -1 ? 0 : 1)[0] ?? SHARED_NUMBER;
  }

  #createCounts(): Int32Array {
    const { limitBytes, ownerLimitBytes, parts = 1 } = this.#options;
    const pages = (bytes: number): number => Math.floor(bytes / parts / PAGE_BYTES);
    return createMemoryCounts({ all: pages(limitBytes), owner: pages(ownerLimitBytes) }, (bytes) =>
      this.#buffer(bytes),
    );
  }

  #buffer(bytes: number): ArrayBufferLike {
    return this.#options.parts === undefined
      ? new SharedArrayBuffer(bytes)
      : new ArrayBuffer(bytes);
  }
}
