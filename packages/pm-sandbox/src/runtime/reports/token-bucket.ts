/** Allows so many units a second in the long run, and so many at once. [PM-55] */
export class TokenBucket {
  readonly #perSecond: number;
  readonly #capacity: number;
  #tokens: number;
  #filledMs: number;

  /**
   * @param nowMs monotonic milliseconds, as in `take`
   * @param capacity what is allowed at once; as much as in a second unless said otherwise
   */
  constructor(perSecond: number, nowMs: number, capacity = perSecond) {
    this.#perSecond = perSecond;
    this.#capacity = capacity;
    this.#tokens = capacity;
    this.#filledMs = nowMs;
  }

  /** Whether so many units are left. Takes none. */
  has(amount: number, nowMs: number): boolean {
    this.#fill(nowMs);
    return this.#tokens >= amount;
  }

  /** Takes units, or none and returns false when there are not as many. */
  take(amount: number, nowMs: number): boolean {
    if (!this.has(amount, nowMs)) return false;
    this.#tokens -= amount;
    return true;
  }

  /** Takes units that are spent already, going into debt if need be. Returns whether some are left. */
  spend(amount: number, nowMs: number): boolean {
    this.#fill(nowMs);
    this.#tokens -= amount;
    return this.#tokens > 0;
  }

  #fill(nowMs: number): void {
    const grown = ((nowMs - this.#filledMs) * this.#perSecond) / 1000;
    this.#tokens = Math.min(this.#capacity, this.#tokens + grown);
    this.#filledMs = nowMs;
  }
}
