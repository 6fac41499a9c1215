import type { Cancel, Clock } from '@ubii/timing';

interface Address {
  nextMs: number;
  waiting: (() => void) | undefined;
  cancel: Cancel | undefined;
}

/** What becomes of a value. `replaced`: it is sent later, in place of one that waited. */
export type Offered = 'now' | 'later' | 'replaced' | 'full';

/** Addresses that a mapping makes, each with values at most so often; the newest value is always sent in the end. [BR-31] */
export class Sampler {
  readonly #clock: Clock;
  readonly #intervalMs: number;
  readonly #maxAddresses: number;
  readonly #addresses = new Map<string, Address>();

  /** @param maxRateHz 0: no limit */
  constructor(clock: Clock, maxRateHz: number, maxAddresses: number) {
    this.#clock = clock;
    this.#intervalMs = maxRateHz > 0 ? 1000 / maxRateHz : 0;
    this.#maxAddresses = maxAddresses;
  }

  get size(): number {
    return this.#addresses.size;
  }

  /** Sends the value now, or when its time has come. */
  offer(address: string, send: () => void): Offered {
    const nowMs = this.#clock.monotonicMs();
    let entry = this.#addresses.get(address);
    if (entry === undefined) {
      if (this.#addresses.size >= this.#maxAddresses) return 'full';
      entry = { nextMs: nowMs, waiting: undefined, cancel: undefined };
      this.#addresses.set(address, entry);
    }
    if (nowMs >= entry.nextMs && entry.waiting === undefined) {
      entry.nextMs = nowMs + this.#intervalMs;
      send();
      return 'now';
    }
    const isReplaced = entry.waiting !== undefined;
    entry.waiting = send;
    entry.cancel ??= this.#clock.after(entry.nextMs - nowMs, () => this.#sendWaiting(entry));
    return isReplaced ? 'replaced' : 'later';
  }

  has(address: string): boolean {
    return this.#addresses.has(address);
  }

  /** The address has no value any more, or one from elsewhere: what waits is not sent. */
  end(address: string): void {
    this.#addresses.get(address)?.cancel?.();
    this.#addresses.delete(address);
  }

  close(): void {
    for (const address of [...this.#addresses.keys()]) this.end(address);
  }

  #sendWaiting(entry: Address): void {
    const { waiting } = entry;
    entry.waiting = undefined;
    entry.cancel = undefined;
    entry.nextMs = this.#clock.monotonicMs() + this.#intervalMs;
    waiting?.();
  }
}
