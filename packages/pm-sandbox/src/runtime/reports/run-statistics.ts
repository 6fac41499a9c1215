/** Runs whose durations are kept between two reports: four seconds of a report's interval at 60 Hz. */
const KEPT = 256;

/** Durations of the newest runs, in bounded memory. [PM-80] */
export class RunDurations {
  readonly #ring = new Float64Array(KEPT);
  #count = 0;
  #newest = { p50Ms: 0, p95Ms: 0 };

  add(durationMs: number): void {
    this.#ring[this.#count++ % KEPT] = durationMs;
  }

  /**
   * Median and 95th percentile of what was added since the call before, milliseconds. With nothing added they stay: a
   * run may take longer than the time between two reports.
   */
  take(): { readonly p50Ms: number; readonly p95Ms: number } {
    if (this.#count === 0) return this.#newest;
    const sorted = this.#ring.slice(0, Math.min(this.#count, KEPT)).sort();
    this.#count = 0;
    this.#newest = { p50Ms: percentile(sorted, 0.5), p95Ms: percentile(sorted, 0.95) };
    return this.#newest;
  }
}

/** The nearest rank of sorted values. */
function percentile(sorted: Float64Array, share: number): number {
  return sorted[Math.max(0, Math.ceil(share * sorted.length) - 1)] ?? 0;
}

/** So many runs make a rate; fewer would jump between 0 and 1 for a module that runs less than once a second. */
const ENOUGH_RUNS = 5;
/** Longest window, milliseconds. */
const MAX_MS = 5000;

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
      runs - one.runs >= ENOUGH_RUNS || nowMs - one.atMs >= MAX_MS;
    const since =
      expected >= ENOUGH_RUNS ? last : (this.#taken.findLast(isEnough) ?? this.#taken[0]!);
    this.#taken = [...this.#taken.slice(this.#taken.indexOf(since)), { runs, atMs: nowMs }];
    const seconds = (nowMs - since.atMs) / 1000;
    this.#rateHz = seconds > 0 ? (runs - since.runs) / seconds : 0;
    return this.#rateHz;
  }
}
