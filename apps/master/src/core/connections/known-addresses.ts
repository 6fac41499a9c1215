import type { Clock } from '@ubii/timing';

/** Addresses remembered; those of the longest ago go first. */
const MAX_ADDRESSES = 4_096;

/** Addresses with recent requests of joined callers. */
export class KnownAddresses {
  readonly #clock: Clock;
  readonly #keptMs: number;
  readonly #seenMs = new Map<string, number>();

  /** @param keptMs how long an address counts after the last call from it */
  constructor(clock: Clock, keptMs: number) {
    this.#clock = clock;
    this.#keptMs = keptMs;
  }

  has(address: string): boolean {
    const seenMs = this.#seenMs.get(address);
    return seenMs !== undefined && this.#clock.monotonicMs() - seenMs < this.#keptMs;
  }

  add(address: string): void {
    this.#seenMs.delete(address);
    this.#seenMs.set(address, this.#clock.monotonicMs());
    if (this.#seenMs.size <= MAX_ADDRESSES) return;
    const [first] = this.#seenMs.keys();
    if (first !== undefined) this.#seenMs.delete(first);
  }
}
