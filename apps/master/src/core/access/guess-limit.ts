import type { Clock } from '../ports/clock.ts';
import type { LimitWatch } from '../status/limit-watch.ts';

/** The time over which wrong codes are counted, milliseconds. */
const WINDOW_MS = 60_000;

/** Counts wrong codes, so that nobody finds a right one by trying [AC-17]. */
export class GuessLimit {
  readonly #clock: Clock;
  readonly #limits: LimitWatch;
  /** Wrong codes of this window by place. Never more entries than wrong codes in a window. */
  readonly #byPlace = new Map<string, number>();
  #total = 0;
  #windowMs = Number.NEGATIVE_INFINITY;

  constructor(clock: Clock, limits: LimitWatch) {
    this.#clock = clock;
    this.#limits = limits;
  }

  /** Whether a code from this place is looked at now. */
  mayTry(place: string): boolean {
    const nowMs = this.#clock.monotonicMs();
    if (nowMs - this.#windowMs >= WINDOW_MS) {
      this.#windowMs = nowMs;
      this.#total = 0;
      this.#byPlace.clear();
    }
    const { wrongCodes, wrongCodesPerAddress } = this.#limits.limits;
    if (this.#total >= wrongCodes) {
      this.#limits.count('wrongCodes');
      return false;
    }
    if ((this.#byPlace.get(place) ?? 0) >= wrongCodesPerAddress) {
      this.#limits.count('wrongCodesPerAddress');
      return false;
    }
    return true;
  }

  /** A code from this place was wrong. */
  countWrong(place: string): void {
    this.#total++;
    this.#byPlace.set(place, (this.#byPlace.get(place) ?? 0) + 1);
  }
}
