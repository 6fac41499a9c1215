import { TokenBucket } from '@ubii/timing';
import type { Cancel, Clock } from '@ubii/timing';
import { BRIDGE_LIMITS } from '../limits.ts';

interface Address {
  nextMs: number;
  /** When the newest value came, or was sent. */
  usedMs: number;
  waiting: (() => void) | undefined;
  cancel: Cancel | undefined;
}

/** Result of an offer. `replaced`: it is sent later, in place of a waiting value. */
export type Offered = 'now' | 'later' | 'replaced' | 'full';

export interface SamplerContext {
  readonly clock: Clock;
  /** 0: no limit. */
  readonly maxRateHz: number;
  readonly maxAddresses: number;
  /** The address was quiet for longest, and made room for a new one. [BR-34] */
  readonly handleEvicted?: (address: string) => void;
}

/** Addresses that a mapping makes, each with values at most so often; the newest value is always sent in the end. [BR-31] */
export class Sampler {
  readonly #context: SamplerContext;
  readonly #intervalMs: number;
  readonly #evictions: TokenBucket;
  /** In the order of their use: the first has been quiet for longest. */
  readonly #addresses = new Map<string, Address>();

  constructor(context: SamplerContext) {
    const { clock, maxRateHz } = context;
    this.#context = context;
    this.#intervalMs = maxRateHz > 0 ? 1000 / maxRateHz : 0;
    this.#evictions = new TokenBucket(BRIDGE_LIMITS.evictionsPerSecond, clock.monotonicMs());
  }

  get size(): number {
    return this.#addresses.size;
  }

  /** Sends the value now, or when its time has come. */
  offer(address: string, send: () => void): Offered {
    const nowMs = this.#context.clock.monotonicMs();
    const entry = this.#addresses.get(address) ?? this.#add(nowMs);
    if (entry === undefined) return 'full';
    this.#use(address, entry, nowMs);
    if (nowMs >= entry.nextMs && entry.waiting === undefined) {
      entry.nextMs = nowMs + this.#intervalMs;
      send();
      return 'now';
    }
    const isReplaced = entry.waiting !== undefined;
    entry.waiting = send;
    entry.cancel ??= this.#context.clock.after(entry.nextMs - nowMs, () =>
      this.#sendWaiting(address, entry),
    );
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

  /** Room for a new address; undefined: all are in use. */
  #add(nowMs: number): Address | undefined {
    const isFull = this.#addresses.size >= this.#context.maxAddresses;
    if (isFull && !this.#evictQuietest(nowMs)) return undefined;
    return { nextMs: nowMs, usedMs: nowMs, waiting: undefined, cancel: undefined };
  }

  /** Evicts slowly, and never what is in use, so that a flood cannot take the place of what was there. [BR-34] */
  #evictQuietest(nowMs: number): boolean {
    for (const [address, { usedMs, waiting }] of this.#addresses) {
      const isQuiet = waiting === undefined && nowMs - usedMs >= BRIDGE_LIMITS.quietMs;
      if (!isQuiet || !this.#evictions.take(1, nowMs)) return false;
      this.end(address);
      this.#context.handleEvicted?.(address);
      return true;
    }
    return false;
  }

  #use(address: string, entry: Address, nowMs: number): void {
    entry.usedMs = nowMs;
    this.#addresses.delete(address);
    this.#addresses.set(address, entry);
  }

  #sendWaiting(address: string, entry: Address): void {
    const { waiting } = entry;
    const nowMs = this.#context.clock.monotonicMs();
    entry.waiting = undefined;
    entry.cancel = undefined;
    entry.nextMs = nowMs + this.#intervalMs;
    this.#use(address, entry, nowMs);
    waiting?.();
  }
}
