import { histogramOf } from '../../measure/histogram.ts';
import type { TestResult } from '../test-result.ts';

/** Result for tests. */
export function aResult(change: Partial<TestResult> = {}): TestResult {
  return {
    id: 'one',
    kind: 'round-trip',
    name: 'Round trip',
    startedMs: Date.UTC(2026, 0, 2, 3, 4, 5),
    durationMs: 10_000,
    ended: 'complete',
    parameters: [{ key: 'rate', label: 'Rate', value: 100, unit: 'Hz' }],
    circumstances: [{ key: 'browser', label: 'Browser', value: 'Firefox 110, "nightly"' }],
    findings: {
      figures: [
        { key: 'immediate.p50', label: 'p50', value: 1.5, unit: 'ms', decimals: 2, better: 'less' },
      ],
      histograms: [histogramOf('immediate', 'Immediate', [1, 1, 2])!],
      curves: [
        {
          key: 'immediate',
          title: 'Over time',
          x: { label: 'Time', unit: 's', values: [0, 1] },
          y: { label: 'Duration', unit: 'ms' },
          lines: [{ key: 'p50', label: 'p50', values: [1.5, null] }],
          mark: { x: 1, text: 'knee' },
        },
      ],
      notes: ['A note.'],
    },
    ...change,
  };
}
