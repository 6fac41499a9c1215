import { describe, expect, it } from 'vitest';
import { NO_FINDINGS, type Figure } from '../measure/findings.ts';
import { aResult } from '../results/testing/a-result.ts';
import { compareFacts, compareFigures } from './compare-figures.ts';

const run = (name: string, ...figures: Figure[]) =>
  aResult({ id: name, name, findings: { ...NO_FINDINGS, figures } });
const p95 = (value: number): Figure => ({
  key: 'p95',
  label: 'p95',
  value,
  unit: 'ms',
  better: 'less',
});

describe('comparing runs', () => {
  it('says what is better and what is worse than the first', () => {
    const [row] = compareFigures([run('a', p95(10)), run('b', p95(5)), run('c', p95(20))]);
    expect(row!.cells.map((cell) => [cell!.changePercent, cell!.change])).toEqual([
      [undefined, undefined],
      [-50, 'better'],
      [100, 'worse'],
    ]);
  });

  it('takes small differences for chance', () => {
    const [row] = compareFigures([run('a', p95(10)), run('b', p95(10.5))]);
    expect(row!.cells[1]!.change).toBeUndefined();
  });

  it('knows that more runs are better', () => {
    const runs = (value: number): Figure => ({
      key: 'runs',
      label: 'Runs',
      value,
      unit: '/s',
      better: 'more',
    });
    const [row] = compareFigures([run('a', runs(10)), run('b', runs(20))]);
    expect(row!.cells[1]!.change).toBe('better');
  });

  it('leaves a gap where something was not measured, and divides by no 0', () => {
    const rows = compareFigures([run('a', p95(0)), run('b'), run('c', p95(1))]);
    expect(rows[0]!.cells.map((cell) => cell?.changePercent)).toEqual([
      undefined,
      undefined,
      undefined,
    ]);
    expect(rows[0]!.cells[1]).toBeUndefined();
  });

  it('shows first in what the runs differ', () => {
    const facts = compareFacts([
      aResult(),
      aResult({ circumstances: [{ key: 'browser', label: 'Browser', value: 'Other' }] }),
    ]);
    expect(facts.map(({ label, differs }) => [label, differs])).toEqual([
      ['Browser', true],
      ['Rate', false],
    ]);
  });
});
