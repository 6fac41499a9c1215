import type { LinePoints } from '../history/series-ring.ts';
import { gapOf } from './trace-line.ts';

/** Point of a line. */
export interface PlotPoint {
  readonly timeMs: number;
  readonly value: number;
}

/** Returns the point nearest to a time, up to `endMs`; `undefined` when there is none. */
export function pointNear(line: LinePoints, timeMs: number, endMs: number): PlotPoint | undefined {
  const after = line.indexAtOrAfter(timeMs);
  const candidates = [after - 1, after].filter(
    (index) => index >= 0 && index < line.size && line.timeAt(index) <= endMs,
  );
  const [first, second] = candidates;
  if (first === undefined) return undefined;
  const distance = (index: number): number => Math.abs(line.timeAt(index) - timeMs);
  const nearest = second !== undefined && distance(second) < distance(first) ? second : first;
  return { timeMs: line.timeAt(nearest), value: line.valueAt(nearest) };
}

/**
 * Returns the value of a line at a time: the nearest point; `undefined` in a gap or before the first point. The newest
 * value holds until `endMs`.
 */
export function pointAt(line: LinePoints, timeMs: number, endMs: number): PlotPoint | undefined {
  const point = pointNear(line, timeMs, endMs);
  if (point === undefined || timeMs < line.timeAt(0)) return undefined;
  const isHeld = timeMs >= line.timeAt(line.size - 1);
  return isHeld || Math.abs(point.timeMs - timeMs) <= gapOf(line) / 2 ? point : undefined;
}
