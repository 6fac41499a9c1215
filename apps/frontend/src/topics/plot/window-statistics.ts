import type { LinePoints } from '../history/series-ring.ts';

/** What a line did within a window. */
export interface LineStatistics {
  readonly count: number;
  readonly min: number;
  readonly mean: number;
  readonly max: number;
  /** Standard deviation of the values, not an estimate of a larger set's. */
  readonly deviation: number;
  /** Values that are no number or infinite; they count nowhere else. */
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
    // Welford: the plain sum of squares loses the digits of a large mean.
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
