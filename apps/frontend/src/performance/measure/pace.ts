/**
 * Counts the records that are due, to keep a rate with late timers. Delays are compensated, but with at most
 * `maxAtOnce` records: a burst would measure itself.
 */
export class Pace {
  readonly #intervalMs: number;
  readonly #maxAtOnce: number;
  #nextMs: number;
  #skipped = 0;

  constructor(ratePerSecond: number, startMs: number, maxAtOnce = Infinity) {
    this.#intervalMs = 1000 / ratePerSecond;
    this.#nextMs = startMs;
    this.#maxAtOnce = maxAtOnce;
  }

  /** Number of records skipped because the timer was too late. */
  get skipped(): number {
    return this.#skipped;
  }

  due(nowMs: number): number {
    if (nowMs < this.#nextMs) return 0;
    const all = Math.floor((nowMs - this.#nextMs) / this.#intervalMs) + 1;
    this.#nextMs += all * this.#intervalMs;
    const due = Math.min(all, this.#maxAtOnce);
    this.#skipped += all - due;
    return due;
  }
}
