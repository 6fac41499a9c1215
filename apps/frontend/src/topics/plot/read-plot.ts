import type { SeriesRing } from '../history/series-ring.ts';
import { gapOf } from './trace-line.ts';
import type { Range } from './value-axis.ts';

/** The lowest and the highest value of all lines in a window, with the one value held into it. */
export function valuesWithin(ring: SeriesRing, startMs: number, endMs: number): Range | undefined {
  let [min, max] = [Infinity, -Infinity];
  for (let i = Math.max(0, ring.indexAtOrAfter(startMs) - 1); i < ring.size; i++) {
    if (ring.timeAt(i) > endMs) break;
    for (let line = 0; line < ring.lines; line++) {
      const value = ring.valueAt(line, i);
      if (value < min) min = value;
      if (value > max) max = value;
    }
  }
  return Number.isFinite(min) && Number.isFinite(max) ? { min, max } : undefined;
}

/** One point of the lines. */
export interface PlotPoint {
  readonly timeMs: number;
  readonly values: readonly number[];
}

/** The point nearest to a moment, up to `endMs`; `undefined` when there is none. */
export function pointNear(ring: SeriesRing, timeMs: number, endMs: number): PlotPoint | undefined {
  const after = ring.indexAtOrAfter(timeMs);
  const candidates = [after - 1, after].filter(
    (index) => index >= 0 && index < ring.size && ring.timeAt(index) <= endMs,
  );
  const [first, second] = candidates;
  if (first === undefined) return undefined;
  const distance = (index: number): number => Math.abs(ring.timeAt(index) - timeMs);
  const nearest = second !== undefined && distance(second) < distance(first) ? second : first;
  return {
    timeMs: ring.timeAt(nearest),
    values: Array.from({ length: ring.lines }, (_, line) => ring.valueAt(line, nearest)),
  };
}

/**
 * What the lines say at a moment: the nearest point, unless the moment lies in a gap or before the
 * first point. The newest value holds until `endMs`.
 */
export function pointAt(ring: SeriesRing, timeMs: number, endMs: number): PlotPoint | undefined {
  const point = pointNear(ring, timeMs, endMs);
  if (point === undefined) return undefined;
  const isHeld = timeMs >= ring.timeAt(ring.size - 1);
  return isHeld || Math.abs(point.timeMs - timeMs) <= gapOf(ring) / 2 ? point : undefined;
}
