import type { SeriesRing } from '../history/series-ring.ts';

/** What a line did within a window. */
export interface LineStatistics {
  readonly min: number;
  readonly mean: number;
  readonly max: number;
  /** Standard deviation of the values, not an estimate of a larger set's. */
  readonly deviation: number;
}

/** `undefined` when the line has no value from `startMs` to `endMs`. */
export function statisticsOf(
  ring: SeriesRing,
  line: number,
  startMs: number,
  endMs: number,
): LineStatistics | undefined {
  let [count, mean, squares] = [0, 0, 0];
  let [min, max] = [Infinity, -Infinity];
  for (let i = ring.indexAtOrAfter(startMs); i < ring.size && ring.timeAt(i) <= endMs; i++) {
    const value = ring.valueAt(line, i);
    if (!Number.isFinite(value)) continue;
    // Welford: the plain sum of squares loses the digits of a large mean.
    count++;
    const before = value - mean;
    mean += before / count;
    squares += before * (value - mean);
    if (value < min) min = value;
    if (value > max) max = value;
  }
  return count === 0 ? undefined : { min, mean, max, deviation: Math.sqrt(squares / count) };
}
