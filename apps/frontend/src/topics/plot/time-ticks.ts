import { formatClock } from '../../ui/readouts/format-clock.ts';

/** Possible steps of the time grid, milliseconds. */
const STEPS_MS = [
  1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 15_000, 30_000, 60_000, 120_000,
  300_000,
];
const MINUTE_MS = 60_000;

/** Line of the time grid. */
export interface TimeTick {
  readonly timeMs: number;
  readonly text: string;
}

/**
 * Grid lines at round distances from the end: for a plot that follows the newest data, where these stay in place.
 * @param count approximate number
 * @param endText label at the end
 */
export function ticksBefore(
  startMs: number,
  endMs: number,
  count: number,
  endText: string,
): TimeTick[] {
  const stepMs = stepOf(endMs - startMs, count);
  const isMinutes = stepMs % MINUTE_MS === 0;
  const ticks: TimeTick[] = [];
  for (let i = 0; endMs - i * stepMs >= startMs - 1e-6; i++) {
    const beforeMs = i * stepMs;
    const text = isMinutes ? `−${beforeMs / MINUTE_MS} min` : `−${beforeMs / 1000} s`;
    ticks.push({ timeMs: endMs - beforeMs, text: i === 0 ? endText : text });
  }
  return ticks.reverse();
}

/** Grid lines at round local times. */
export function clockTicks(startMs: number, endMs: number, count: number): TimeTick[] {
  const stepMs = stepOf(endMs - startMs, count);
  const ticks: TimeTick[] = [];
  for (let timeMs = Math.ceil(startMs / stepMs) * stepMs; timeMs <= endMs; timeMs += stepMs) {
    ticks.push({ timeMs, text: formatClock(timeMs, stepMs < 1000 ? 'millisecond' : 'second') });
  }
  return ticks;
}

function stepOf(spanMs: number, count: number): number {
  const rough = spanMs / Math.max(1, count);
  return STEPS_MS.find((step) => step >= rough) ?? STEPS_MS.at(-1)!;
}

/** Formats a duration in the shortest unit: `250 ms`, `10 s`, `1.5 min`. */
export function spanText(spanMs: number): string {
  const short = (value: number): string => String(Number(value.toPrecision(3)));
  if (spanMs < 1000) return `${short(spanMs)} ms`;
  if (spanMs < MINUTE_MS) return `${short(spanMs / 1000)} s`;
  return `${short(spanMs / MINUTE_MS)} min`;
}
