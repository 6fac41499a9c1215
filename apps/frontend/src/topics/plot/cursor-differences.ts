import type { LinePoints } from '../history/series-ring.ts';
import { pointAt } from './read-plot.ts';
import { statisticsOf, type LineStatistics } from './window-statistics.ts';

/** Times of two cursors, this computer's clock, in any order. */
export interface CursorPair {
  readonly aMs: number;
  readonly bMs: number;
}

/** Time between two cursors. */
export interface TimeDifference {
  /** From A to B; negative when B is earlier. */
  readonly deltaMs: number;
  /** Reciprocal of the time between them; `undefined` when it is zero. */
  readonly hz: number | undefined;
}

export function timeDifference({ aMs, bMs }: CursorPair): TimeDifference {
  const deltaMs = bMs - aMs;
  return { deltaMs, hz: deltaMs === 0 ? undefined : 1000 / Math.abs(deltaMs) };
}

/** Values of a line at two cursors, and their difference. */
export interface LineDifference {
  readonly a: number | undefined;
  readonly b: number | undefined;
  /** From A to B. */
  readonly delta: number | undefined;
  readonly between: LineStatistics | undefined;
}

/** @param endMs end of the visible time; later points are ignored */
export function lineDifference(
  line: LinePoints,
  { aMs, bMs }: CursorPair,
  endMs: number,
): LineDifference {
  const a = pointAt(line, aMs, endMs)?.value;
  const b = pointAt(line, bMs, endMs)?.value;
  return {
    a,
    b,
    delta: a === undefined || b === undefined ? undefined : b - a,
    between: statisticsOf(line, Math.min(aMs, bMs), Math.min(endMs, Math.max(aMs, bMs))),
  };
}
