import type { DurationSummary } from './durations.ts';
import type { Figure } from './findings.ts';

const PARTS = [
  ['p50', 'p50', 'p50Ms'],
  ['p95', 'p95', 'p95Ms'],
  ['p99', 'p99', 'p99Ms'],
  ['max', 'Slowest', 'maxMs'],
] as const satisfies readonly (readonly [string, string, keyof DurationSummary])[];

/** A duration as a figure, milliseconds. */
export function durationFigure(key: string, label: string, valueMs: number): Figure {
  return { key, label, value: valueMs, unit: 'ms', decimals: 2, better: 'less' };
}

/**
 * The percentiles of durations.
 * @param key begins the keys: `<key>.p50`
 * @param label begins the labels; empty for a test with one kind of duration
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
