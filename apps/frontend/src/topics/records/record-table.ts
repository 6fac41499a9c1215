import type { RecordLine } from '../history/topic-history.ts';

/** A distance this much longer than usual is marked. */
const OUTLIER = 1.8;
/** Shorter distances vary by themselves, milliseconds. */
const NOISE_MS = 4;

/** What counts as late in these records, milliseconds; `undefined` while there are too few to tell. */
export function lateAfterMs(lines: readonly RecordLine[]): number | undefined {
  const deltas = lines.flatMap(({ deltaMs }) => (deltaMs === undefined ? [] : [deltaMs]));
  if (deltas.length < 8) return undefined;
  const median = deltas.sort((a, b) => a - b)[deltas.length >> 1]!;
  return Math.max(OUTLIER * median, median + NOISE_MS);
}
