import type { LinePoints } from '../history/series-ring.ts';
import { pointAt } from './read-plot.ts';
import { statisticsOf, type LineStatistics } from './window-statistics.ts';

/** Two moments, this machine's clock, in any order. */
export interface CursorPair {
  readonly aMs: number;
  readonly bMs: number;
}

/** What lies between two moments. */
export interface TimeDifference {
  /** From A to B; negative when B is earlier. */
  readonly deltaMs: number;
  /** How often the time between them fits into a second; `undefined` when it is none. */
  readonly hz: number | undefined;
}

export function timeDifference({ aMs, bMs }: CursorPair): TimeDifference {
  const deltaMs = bMs - aMs;
  return { deltaMs, hz: deltaMs === 0 ? undefined : 1000 / Math.abs(deltaMs) };
}

/** What a line does at two cursors and between them. */
export interface LineDifference {
  readonly a: number | undefined;
  readonly b: number | undefined;
  /** From A to B. */
  readonly delta: number | undefined;
  readonly between: LineStatistics | undefined;
}

/** @param endMs the end of what is shown: nothing after it is read */
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
