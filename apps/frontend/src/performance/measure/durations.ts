/** Percentiles of durations, milliseconds. */
export interface DurationSummary {
  readonly count: number;
  readonly minMs: number;
  readonly meanMs: number;
  readonly p50Ms: number;
  readonly p95Ms: number;
  readonly p99Ms: number;
  readonly maxMs: number;
  /** Mean difference of consecutive durations, as in RFC 3550 without smoothing. */
  readonly jitterMs: number;
}

/** Number of samples from which every second one is dropped, to bound memory (1.6 MB); percentiles hardly change. */
const MAX_SAMPLES = 200_000;

/** Durations with their end times, in order of arrival. */
export class Durations {
  readonly #moments: number[] = [];
  readonly #durations: number[] = [];
  /** One of this many samples is kept. */
  #keptOf = 1;
  #seen = 0;
  #last: number | undefined;
  #differences = 0;

  /** Number of all added samples, including dropped ones. */
  get count(): number {
    return this.#seen;
  }

  /** Kept samples, milliseconds. */
  get values(): readonly number[] {
    return this.#durations;
  }

  /** Times of `values`, of any clock, milliseconds. */
  get moments(): readonly number[] {
    return this.#moments;
  }

  add(durationMs: number, atMs: number): void {
    if (this.#last !== undefined) this.#differences += Math.abs(durationMs - this.#last);
    this.#last = durationMs;
    if (this.#seen++ % this.#keptOf !== 0) return;
    this.#moments.push(atMs);
    this.#durations.push(durationMs);
    if (this.#durations.length > MAX_SAMPLES) this.#halve();
  }

  /** `undefined` without samples. */
  summary(): DurationSummary | undefined {
    if (this.#durations.length === 0) return undefined;
    const sorted = Float64Array.from(this.#durations).sort();
    let sum = 0;
    for (const duration of sorted) sum += duration;
    return {
      count: this.#seen,
      minMs: sorted[0]!,
      meanMs: sum / sorted.length,
      p50Ms: percentile(sorted, 0.5),
      p95Ms: percentile(sorted, 0.95),
      p99Ms: percentile(sorted, 0.99),
      maxMs: sorted.at(-1)!,
      jitterMs: this.#seen > 1 ? this.#differences / (this.#seen - 1) : 0,
    };
  }

  #halve(): void {
    for (const list of [this.#moments, this.#durations]) {
      let to = 0;
      for (let from = 0; from < list.length; from += 2) list[to++] = list[from]!;
      list.length = to;
    }
    this.#keptOf *= 2;
  }
}

/**
 * Returns the smallest value that at least this share of all values does not exceed (nearest rank).
 * @param sorted ascending, not empty
 */
export function percentile(sorted: ArrayLike<number>, share: number): number {
  return sorted[Math.max(0, Math.ceil(share * sorted.length) - 1)]!;
}

/** Median; `undefined` without values. */
export function median(values: readonly number[]): number | undefined {
  if (values.length === 0) return undefined;
  return percentile(
    [...values].sort((a, b) => a - b),
    0.5,
  );
}
