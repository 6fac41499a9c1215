import { describe, expect, it } from 'vitest';
import { histogramOf } from '../measure/histogram.ts';
import type { Curve, Findings } from '../measure/findings.ts';
import { findingPlots } from './finding-plots.ts';

const curve = (x: number[], y: (number | null)[]): Curve => ({
  key: 'latency',
  title: 'Latency by rate',
  x: { label: 'Rate', unit: '', values: x },
  y: { label: 'Latency', unit: 'ms' },
  lines: [{ key: 'p50', label: 'p50', values: y }],
  mark: { x: x[0]!, text: 'knee' },
});
const findings = (change: Partial<Findings>): Findings => ({
  figures: [],
  histograms: [],
  curves: [],
  notes: [],
  ...change,
});

describe('charts of findings', () => {
  it('show one run with its mark', () => {
    const [plot] = findingPlots([
      { name: 'A', findings: findings({ curves: [curve([1, 2], [3, 9])] }) },
    ]);
    expect(plot!.chart.lines).toMatchObject([{ label: 'p50', values: [3, 9] }]);
    expect(plot!.chart.marks).toHaveLength(1);
    expect(plot!.summary).toBe('p50 3 to 9 ms; knee at 1.');
  });

  it('lay curves over each other where their places differ', () => {
    const [plot] = findingPlots([
      { name: 'A', findings: findings({ curves: [curve([1, 3], [10, 30])] }) },
      { name: 'B', findings: findings({ curves: [curve([2, 4], [5, 6])] }) },
    ]);
    expect(plot!.chart.x).toEqual([1, 2, 3, 4]);
    expect(plot!.chart.lines.map(({ values }) => values)).toEqual([
      [10, 20, 30, null],
      [null, 5, 5.5, 6],
    ]);
    expect(plot!.chart.lines.map(({ label }) => label)).toEqual(['A: p50', 'B: p50']);
  });

  it('lay histograms over each other in percent', () => {
    const [plot] = findingPlots([
      { name: 'A', findings: findings({ histograms: [histogramOf('h', 'H', [1, 1])!] }) },
      { name: 'B', findings: findings({ histograms: [histogramOf('h', 'H', [1, 1, 1, 2])!] }) },
    ]);
    expect(plot!.chart.lines.map(({ values }) => Math.max(...(values as number[])))).toEqual([
      100, 75,
    ]);
    expect(new Set(plot!.chart.lines.map(({ values }) => values.length)).size).toBe(1);
  });

  it('strokes differ from line to line', () => {
    const [plot] = findingPlots(
      ['A', 'B', 'C'].map((name) => ({
        name,
        findings: findings({ curves: [curve([1], [1])] }),
      })),
    );
    const strokes = plot!.chart.lines.map(({ stroke }) => JSON.stringify(stroke));
    expect(new Set(strokes).size).toBe(3);
  });
});
