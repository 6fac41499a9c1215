/** Tolerated increase of a quantity: the larger of the two. */
export interface Tolerance {
  /** Share of the value after warm-up. */
  readonly relative: number;
  readonly absolute: number;
}

/** Course of a quantity from the end of the warm-up to the end of the run. */
export interface Growth {
  /** Medians of the four quarters of the samples, in their order. */
  readonly quarters: readonly [number, number, number, number];
  /** Difference between the last quarter and the first. */
  readonly more: number;
  /** The tolerated difference. */
  readonly tolerated: number;
  /** Every quarter is above the one before, whatever the amount. */
  readonly isRising: boolean;
  /** The last quarter is above the first by more than is tolerated. */
  readonly isGrown: boolean;
}

/**
 * Compares the quarters of a series, by their medians: single peaks, such as a collection of garbage that was late,
 * count for nothing.
 *
 * @throws Error for fewer than eight samples
 */
export function judgeGrowth(series: readonly number[], tolerance: Tolerance): Growth {
  if (series.length < 8) throw new Error('Growth takes eight samples at least.');
  const at = (quarter: number): number => Math.round((series.length * quarter) / 4);
  const medianOf = (quarter: number): number => median(series.slice(at(quarter), at(quarter + 1)));
  const quarters = [medianOf(0), medianOf(1), medianOf(2), medianOf(3)] as const;
  const more = quarters[3] - quarters[0];
  const tolerated = Math.max(tolerance.absolute, tolerance.relative * quarters[0]);
  return {
    quarters,
    more,
    tolerated,
    isRising: quarters.every((value, index) => index === 0 || value > quarters[index - 1]!),
    isGrown: more > tolerated,
  };
}

/** @throws Error for an empty list */
export function median(values: readonly number[]): number {
  if (values.length === 0) throw new Error('Nothing has no median.');
  const sorted = values.toSorted((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle]! : (sorted[middle - 1]! + sorted[middle]!) / 2;
}
