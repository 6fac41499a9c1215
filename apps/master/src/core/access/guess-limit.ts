import type { Clock } from '@ubii/timing';
import type { LimitName } from '../limits/index.ts';
import type { CallerFacts } from '../ports/caller-facts.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';

/** Origin of a code. */
export type GuessSource = Pick<CallerFacts, 'place' | 'address'>;

/** Wrong codes that a place is not held to its own pace for: people mistype twice. */
const FIRST_TRIES = 3;
/** A place without wrong codes for this long is a new one again. */
const FORGET_MS = 60_000;
/** Seconds for which an unused allowance accumulates. */
const BURST_S = 2;
/** Addresses of one network that have a pace of their own; further ones have that of the network. */
const MAX_ADDRESSES = 64;

/** A place that sent wrong codes recently. */
interface Guesser {
  wrong: number;
  lastMs: number;
  readonly allowance: Allowance;
  /** Of a network: by address in it. */
  readonly addresses: Map<string, Allowance>;
}

/**
 * Limits the rate of wrong codes, so that an attacker cannot guess a valid code, and a
 * right one is hardly ever kept waiting: each address, each IPv6 network and all together have a pace;
 * half of the last is for places that were not wrong before, the other half is shared by the others. A
 * right code costs nothing. [AC-17]
 */
export class GuessLimit {
  readonly #clock: Clock;
  readonly #limits: LimitWatch;
  /** Those who were wrong last are last. */
  readonly #guessers = new Map<string, Guesser>();
  readonly #ofNew: Allowance;
  readonly #ofOthers: Allowance;

  constructor(clock: Clock, limits: LimitWatch) {
    this.#clock = clock;
    this.#limits = limits;
    const nowMs = clock.monotonicMs();
    this.#ofNew = new Allowance(this.#half, nowMs);
    this.#ofOthers = new Allowance(this.#half, nowMs);
  }

  /** Whether a code from there is looked at now. If not, a second later it may be. */
  mayTry(source: GuessSource): boolean {
    const full = this.#full(source);
    if (full === undefined) return true;
    this.#limits.count(full);
    return false;
  }

  /** A code from there was wrong. */
  countWrong({ place, address = place }: GuessSource): void {
    const nowMs = this.#clock.monotonicMs();
    let guesser = this.#guessers.get(place);
    if (guesser === undefined) {
      const allowance = new Allowance(this.#paces(address !== place).place, nowMs);
      guesser = { wrong: 0, lastMs: nowMs, allowance, addresses: new Map() };
    }
    (guesser.wrong < FIRST_TRIES ? this.#ofNew : this.#ofOthers).spend();
    guesser.wrong++;
    guesser.lastMs = nowMs;
    guesser.allowance.spend();
    const { addresses } = guesser;
    if (address !== place && addresses.size < MAX_ADDRESSES && !addresses.has(address)) {
      addresses.set(address, new Allowance(this.#paces(true).address, nowMs));
    }
    addresses.get(address)?.spend();
    this.#guessers.delete(place);
    this.#guessers.set(place, guesser);
  }

  /** The limit that this source meets now. */
  #full({ place, address = place }: GuessSource): LimitName | undefined {
    const nowMs = this.#clock.monotonicMs();
    this.#forget(nowMs);
    const guesser = this.#guessers.get(place);
    if (guesser === undefined || guesser.wrong < FIRST_TRIES) {
      return this.#ofNew.isLeft(this.#half, nowMs) ? undefined : 'wrongCodes';
    }
    const isNetwork = address !== place;
    const paces = this.#paces(isNetwork);
    const own = guesser.addresses.get(address);
    if (own !== undefined && !own.isLeft(paces.address, nowMs)) return 'wrongCodesPerAddress';
    if (!guesser.allowance.isLeft(paces.place, nowMs)) {
      return isNetwork ? 'wrongCodesPerNetwork' : 'wrongCodesPerAddress';
    }
    return this.#ofOthers.isLeft(this.#half, nowMs) ? undefined : 'wrongCodes';
  }

  /** Wrong codes a second, of those of whom each was wrong before. */
  #paces(isNetwork: boolean): { readonly place: number; readonly address: number } {
    const { wrongCodesPerAddress, wrongCodesPerNetwork } = this.#limits.limits;
    const share = this.#half / Math.max(1, this.#guessers.size);
    return {
      place: Math.min(isNetwork ? wrongCodesPerNetwork : wrongCodesPerAddress, share),
      address: Math.min(wrongCodesPerAddress, share / 2),
    };
  }

  get #half(): number {
    return this.#limits.limits.wrongCodes / 2;
  }

  #forget(nowMs: number): void {
    for (const [place, { lastMs }] of this.#guessers) {
      if (nowMs - lastMs < FORGET_MS) return;
      this.#guessers.delete(place);
    }
  }
}

/** Remaining budget, refilled at a rate that may change. */
class Allowance {
  #left: number;
  #filledMs: number;

  /** @param perSecond the pace at the beginning */
  constructor(perSecond: number, nowMs: number) {
    this.#left = Math.max(1, perSecond * BURST_S);
    this.#filledMs = nowMs;
  }

  /** Whether one can be spent, when it has grown by so many a second since the last call. */
  isLeft(perSecond: number, nowMs: number): boolean {
    const grown = this.#left + ((nowMs - this.#filledMs) / 1_000) * perSecond;
    this.#left = Math.min(grown, Math.max(1, perSecond * BURST_S));
    this.#filledMs = nowMs;
    // Sums of fractions fall short of the whole.
    return this.#left > 1 - 1e-9;
  }

  spend(): void {
    this.#left -= 1;
  }
}
