import type { RecordLine } from '../history/topic-history.ts';

/** Factor on the usual interval from which an interval is marked as late. */
const OUTLIER = 1.8;
/** Smaller differences are jitter, milliseconds. */
const NOISE_MS = 4;

/** Returns the interval from which a record is late, milliseconds; `undefined` while there are too few records. */
export function lateAfterMs(lines: readonly RecordLine[]): number | undefined {
  const deltas = lines.flatMap(({ deltaMs }) => (deltaMs === undefined ? [] : [deltaMs]));
  if (deltas.length < 8) return undefined;
  const median = deltas.sort((a, b) => a - b)[deltas.length >> 1]!;
  return Math.max(OUTLIER * median, median + NOISE_MS);
}
