import { linePath } from '../../ui/charts/line-path.ts';
import type { RunTime } from '../live/live-graph.ts';

/** Time span of the chart, milliseconds. */
export const CHART_MS = 60_000;
/** Longest time between two points that are connected, milliseconds. */
const GAP_MS = 5000;

/** Chart of run times, in pixels of its box. */
export interface RunTimeLines {
  readonly p50: string;
  readonly p95: string;
  /** Slowest recent run time, and its position. */
  readonly peak: { readonly ms: number; readonly x: number } | undefined;
  readonly newest: RunTime | undefined;
  /** Heights of the ends of the lines. */
  readonly ends: { readonly p50: number; readonly p95: number };
}

/** Returns the lines of the last minute, with gaps. @param nowMs current time of the clock of `times`, milliseconds */
export function runTimeLines(
  times: readonly RunTime[],
  nowMs: number,
  { width, height }: { readonly width: number; readonly height: number },
): RunTimeLines {
  const shown = times.filter(({ timeMs }) => nowMs - timeMs <= CHART_MS);
  const max = Math.max(0.001, ...shown.map(({ p95Ms }) => p95Ms));
  const x = (timeMs: number): number => width * (1 - (nowMs - timeMs) / CHART_MS);
  const y = (ms: number): number => height - 1 - (ms / max) * (height - 3);
  const lineOf = (of: (time: RunTime) => number): string =>
    linePath(
      shown.flatMap((time, index) => {
        const before = shown[index - 1];
        const point = { x: x(time.timeMs), y: y(of(time)) };
        const isGap = before !== undefined && time.timeMs - before.timeMs > GAP_MS;
        return isGap ? [{ x: point.x, y: undefined }, point] : [point];
      }),
    );
  const newest = shown.at(-1);
  const slowest = shown.find(({ p95Ms }) => p95Ms === max);
  return {
    p50: lineOf(({ p50Ms }) => p50Ms),
    p95: lineOf(({ p95Ms }) => p95Ms),
    peak: slowest && { ms: slowest.p95Ms, x: x(slowest.timeMs) },
    newest,
    ends: { p50: y(newest?.p50Ms ?? 0), p95: y(newest?.p95Ms ?? 0) },
  };
}
