/** Allows so many units a second in the long run, and as many at once. [PM-55] */
export class TokenBucket {
  readonly #perSecond: number;
  #tokens: number;
  #filledMs: number;

  /** @param nowMs monotonic milliseconds, as in `take` */
  constructor(perSecond: number, nowMs: number) {
    this.#perSecond = perSecond;
    this.#tokens = perSecond;
    this.#filledMs = nowMs;
  }

  /** Whether so many units are left. Takes none. */
  has(amount: number, nowMs: number): boolean {
    const grown = ((nowMs - this.#filledMs) * this.#perSecond) / 1000;
    this.#tokens = Math.min(this.#perSecond, this.#tokens + grown);
    this.#filledMs = nowMs;
    return this.#tokens >= amount;
  }

  /** Takes units, or none and returns false when there are not as many. */
  take(amount: number, nowMs: number): boolean {
    if (!this.has(amount, nowMs)) return false;
    this.#tokens -= amount;
    return true;
  }
}
