import type { LinePoints } from '../history/series-ring.ts';

/** Statistics of a line within a window. */
export interface LineStatistics {
  readonly count: number;
  readonly min: number;
  readonly mean: number;
  readonly max: number;
  /** Standard deviation of the population, not of a sample. */
  readonly deviation: number;
  /** Number of values that are NaN or infinite; excluded from the other statistics. */
  readonly odd: number;
}

/** `undefined` when the line has no value from `startMs` to `endMs`. */
export function statisticsOf(
  line: LinePoints,
  startMs: number,
  endMs: number,
): LineStatistics | undefined {
  let [count, mean, squares, odd] = [0, 0, 0, 0];
  let [min, max] = [Infinity, -Infinity];
  for (let i = line.indexAtOrAfter(startMs); i < line.size && line.timeAt(i) <= endMs; i++) {
    const value = line.valueAt(i);
    if (!Number.isFinite(value)) {
      odd++;
      continue;
    }
    // Welford's algorithm: the plain sum of squares loses precision for a large mean.
    count++;
    const before = value - mean;
    mean += before / count;
    squares += before * (value - mean);
    if (value < min) min = value;
    if (value > max) max = value;
  }
  if (count === 0) return undefined;
  return { count, min, mean, max, deviation: Math.sqrt(squares / count), odd };
}
