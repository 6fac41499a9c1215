/** Durations kept for percentiles: more than a report sees at 240 Hz. */
const MAX_SAMPLES = 512;

/** Collects durations between two reports. */
export class Durations {
  #values: number[] = [];
  #sinceMs: number;

  constructor(nowMs: number) {
    this.#sinceMs = nowMs;
  }

  add(durationMs: number): void {
    if (this.#values.length < MAX_SAMPLES) this.#values.push(durationMs);
  }

  /** Returns the statistics since the last call. Times are monotonic milliseconds. */
  take(nowMs: number): { perSecond: number; p50Ms: number; p95Ms: number } {
    const sorted = this.#values.sort((a, b) => a - b);
    const seconds = (nowMs - this.#sinceMs) / 1000;
    this.#values = [];
    this.#sinceMs = nowMs;
    return {
      perSecond: seconds > 0 ? sorted.length / seconds : 0,
      p50Ms: quantile(sorted, 0.5),
      p95Ms: quantile(sorted, 0.95),
    };
  }
}

/** Nearest rank. */
function quantile(sorted: readonly number[], share: number): number {
  return sorted[Math.max(0, Math.ceil(sorted.length * share) - 1)] ?? 0;
}
