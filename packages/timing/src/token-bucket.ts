/** Allows `perSecond` units a second in the long run, and up to `capacity` at once. [PM-55] */
export class TokenBucket {
  readonly #perMs: number;
  readonly #capacity: number;
  #tokens: number;
  #filledMs: number;

  /**
   * @param nowMs Monotonic milliseconds, as in every method.
   * @param capacity Default: what grows in a second.
   */
  constructor(perSecond: number, nowMs: number, capacity = perSecond) {
    this.#perMs = perSecond / 1000;
    this.#capacity = capacity;
    this.#tokens = capacity;
    this.#filledMs = nowMs;
  }

  /** Returns whether `amount` units are left. Takes none. */
  has(amount: number, nowMs: number): boolean {
    this.#fill(nowMs);
    return this.#tokens >= amount;
  }

  /** Takes `amount` units, or nothing and returns false when there are not as many. */
  take(amount: number, nowMs: number): boolean {
    this.#fill(nowMs);
    if (this.#tokens < amount) return false;
    this.#tokens -= amount;
    return true;
  }

  /** Takes `amount` units that are spent already, going into debt if need be. Returns whether some are left. */
  spend(amount: number, nowMs: number): boolean {
    this.#fill(nowMs);
    this.#tokens -= amount;
    return this.#tokens > 0;
  }

  /** Milliseconds until there are some units again; 0 when there are. */
  waitMs(nowMs: number): number {
    this.#fill(nowMs);
    return this.#tokens > 0 ? 0 : Math.max(1, Math.ceil(-this.#tokens / this.#perMs));
  }

  #fill(nowMs: number): void {
    if (nowMs === this.#filledMs) return;
    const grown = this.#tokens + (nowMs - this.#filledMs) * this.#perMs;
    this.#tokens = grown < this.#capacity ? grown : this.#capacity;
    this.#filledMs = nowMs;
  }
}
