/** So many runs make a rate; fewer would jump between 0 and 1 for a module that runs less than once a second. */
const ENOUGH_RUNS = 5;
/** Longest window, milliseconds. */
const LONGEST_MS = 5000;

interface Taken {
  readonly runs: number;
  readonly atMs: number;
}

/** Runs per second: of a slow module over the last seconds, of others since they were taken last. */
export class RunRate {
  /** Newest last. */
  #taken: readonly Taken[];
  #rateHz = Infinity;

  constructor(nowMs: number) {
    this.#taken = [{ runs: 0, atMs: nowMs }];
  }

  /**
   * @param runs all runs so far
   * @returns hertz
   */
  take(runs: number, nowMs: number): number {
    const last = this.#taken.at(-1)!;
    const expected = (this.#rateHz * (nowMs - last.atMs)) / 1000;
    const isEnough = (one: Taken): boolean =>
      runs - one.runs >= ENOUGH_RUNS || nowMs - one.atMs >= LONGEST_MS;
    const since =
      expected >= ENOUGH_RUNS ? last : (this.#taken.findLast(isEnough) ?? this.#taken[0]!);
    this.#taken = [...this.#taken.slice(this.#taken.indexOf(since)), { runs, atMs: nowMs }];
    const seconds = (nowMs - since.atMs) / 1000;
    this.#rateHz = seconds > 0 ? (runs - since.runs) / seconds : 0;
    return this.#rateHz;
  }
}
