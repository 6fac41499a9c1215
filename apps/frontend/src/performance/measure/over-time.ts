import type { Curve } from './findings.ts';
import { percentile, type Durations } from './durations.ts';

/** Most points of a curve; more cannot be distinguished on a screen. */
const MAX_POINTS = 120;
/** Shortest interval that is summarised, milliseconds. */
const MIN_STRETCH_MS = 250;

/** Median and 95th percentile over time. Intervals without data are gaps. */
export function overTime(
  key: string,
  title: string,
  durations: Pick<Durations, 'values' | 'moments'>,
  startedMs: number,
): Curve | undefined {
  const lastMs = durations.moments.at(-1);
  if (lastMs === undefined) return undefined;
  const stretchMs = Math.max(MIN_STRETCH_MS, (lastMs - startedMs) / MAX_POINTS);
  const stretches: number[][] = [];
  durations.values.forEach((duration, index) => {
    const at = Math.max(0, Math.floor((durations.moments[index]! - startedMs) / stretchMs));
    (stretches[at] ??= []).push(duration);
  });
  const sorted = Array.from(stretches, (stretch) => stretch?.sort((a, b) => a - b));
  const line = (share: number) =>
    sorted.map((stretch) => (stretch?.length ? percentile(stretch, share) : null));
  return {
    key,
    title,
    x: {
      label: 'Time',
      unit: 's',
      values: sorted.map((_, index) => ((index + 0.5) * stretchMs) / 1000),
    },
    y: { label: 'Duration', unit: 'ms' },
    lines: [
      { key: 'p50', label: 'p50', values: line(0.5) },
      { key: 'p95', label: 'p95', values: line(0.95) },
    ],
  };
}
