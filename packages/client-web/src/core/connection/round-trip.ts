/** Time from a PING of ours to the master's PONG, milliseconds, over the last 60. Masters of ours only. [EX-6] */
export interface RoundTrip {
  readonly lastMs: number;
  readonly p50Ms: number;
  readonly p95Ms: number;
}

/** Measurements kept: two minutes at one every 2 s. */
const WINDOW = 60;

/** The last measurements and their percentiles. */
export class RoundTripWindow {
  #samplesMs: number[] = [];
  #current: RoundTrip | undefined;

  /** `undefined` before the first measurement. */
  get current(): RoundTrip | undefined {
    return this.#current;
  }

  add(sampleMs: number): RoundTrip {
    this.#samplesMs.push(sampleMs);
    if (this.#samplesMs.length > WINDOW) this.#samplesMs.shift();
    const sortedMs = [...this.#samplesMs].sort((a, b) => a - b);
    this.#current = {
      lastMs: sampleMs,
      p50Ms: percentile(sortedMs, 0.5),
      p95Ms: percentile(sortedMs, 0.95),
    };
    return this.#current;
  }

  clear(): void {
    this.#samplesMs = [];
    this.#current = undefined;
  }
}

/** Nearest rank: the smallest value that at least `share` of all values do not exceed. */
function percentile(sorted: readonly number[], share: number): number {
  return sorted[Math.max(0, Math.ceil(share * sorted.length) - 1)]!;
}
