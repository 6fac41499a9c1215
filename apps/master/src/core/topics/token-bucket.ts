/** Allows `perSecond` units a second, and as many at once after a quiet second. */
export class TokenBucket {
  readonly #perMs: number;
  readonly #capacity: number;
  #tokens: number;
  #filledMs: number;

  constructor(perSecond: number, nowMs: number) {
    this.#perMs = perSecond / 1000;
    this.#capacity = perSecond;
    this.#tokens = perSecond;
    this.#filledMs = nowMs;
  }

  /** Takes `amount` units, or nothing and returns false when there are not as many. */
  take(amount: number, nowMs: number): boolean {
    if (nowMs !== this.#filledMs) {
      const grown = this.#tokens + (nowMs - this.#filledMs) * this.#perMs;
      this.#tokens = grown < this.#capacity ? grown : this.#capacity;
      this.#filledMs = nowMs;
    }
    if (this.#tokens < amount) return false;
    this.#tokens -= amount;
    return true;
  }
}
