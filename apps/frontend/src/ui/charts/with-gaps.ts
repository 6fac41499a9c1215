/** Value at a time. */
export interface ChartPoint {
  /** Epoch milliseconds. */
  readonly timeMs: number;
  readonly value: number;
}

/** Inserts a gap between points that are further apart than `maxGapMs`. */
export function withGaps(
  points: readonly ChartPoint[],
  maxGapMs: number,
): { readonly timeMs: number; readonly value: number | undefined }[] {
  const result: { timeMs: number; value: number | undefined }[] = [];
  let before: number | undefined;
  for (const { timeMs, value } of points) {
    if (before !== undefined && timeMs - before > maxGapMs) {
      result.push({ timeMs: before, value: undefined });
    }
    result.push({ timeMs, value });
    before = timeMs;
  }
  return result;
}

/** Returns the point nearest to a time, by binary search; `undefined` without points. */
export function nearestPoint(
  points: readonly ChartPoint[],
  timeMs: number,
): ChartPoint | undefined {
  let low = 0;
  let high = points.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (points[middle]!.timeMs < timeMs) low = middle + 1;
    else high = middle;
  }
  const after = points[low];
  const before = points[low - 1];
  if (!after || !before) return after ?? before;
  return timeMs - before.timeMs <= after.timeMs - timeMs ? before : after;
}
