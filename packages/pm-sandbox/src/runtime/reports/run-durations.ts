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
