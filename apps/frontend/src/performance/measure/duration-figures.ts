import type { DurationSummary } from './durations.ts';
import type { Figure } from './findings.ts';

const PARTS = [
  ['p50', 'p50', 'p50Ms'],
  ['p95', 'p95', 'p95Ms'],
  ['p99', 'p99', 'p99Ms'],
  ['max', 'Slowest', 'maxMs'],
] as const satisfies readonly (readonly [string, string, keyof DurationSummary])[];

/** Creates a figure of a duration, milliseconds. */
export function durationFigure(key: string, label: string, valueMs: number): Figure {
  return { key, label, value: valueMs, unit: 'ms', decimals: 2, better: 'less' };
}

/**
 * Creates the figures of percentiles of durations.
 * @param key prefix of the keys: `<key>.p50`
 * @param label prefix of the labels; empty for a test with one kind of duration
 */
export function durationFigures(
  key: string,
  label: string,
  summary: DurationSummary | undefined,
): Figure[] {
  if (summary === undefined) return [];
  return PARTS.map(([part, word, member]) =>
    durationFigure(
      `${key}.${part}`,
      label === '' ? word : `${label} ${word}`.replace('Slowest', 'slowest'),
      summary[member],
    ),
  );
}
