import { describe, expect, it } from 'vitest';
import type { Measurement } from '../workloads/workload.ts';
import { compareRuns } from './compare-runs.ts';
import { formatRun } from './format-run.ts';
import { compareWithReference, faultsOf, type RunResult } from './results.ts';

const rounds = (values: readonly number[]): Measurement[] =>
  values.map((p50Us) => ({ figures: { p50Us }, deliveries: 10, otherCpuShare: 0.1, faults: [] }));

function runWith(legacy: readonly number[]): RunResult {
  return {
    formatVersion: 1,
    startedAt: '2025-01-01T00:00:00.000Z',
    machine: { node: '20.19.0', cores: 2, cpu: 'any', loadAverage: [0, 0.5], isPlaced: true },
    commit: { hash: '0123456789abcdef', isDirty: false },
    parameters: { rounds: 3, warmUpMs: 1, measureMs: 1 },
    workloads: [
      {
        name: 'round-trip',
        title: 'Round trip',
        figures: [
          {
            key: 'p50Us',
            label: 'p50',
            unit: 'µs',
            isHigherBetter: false,
            goals: { 'ubii-legacy': 1.15 },
          },
        ],
        rounds: { 'raw-ws': rounds([20, 40, 20]), 'ubii-legacy': rounds(legacy) },
      },
    ],
  };
}

describe('compareWithReference', () => {
  it('judges the median of the ratios of each round', () => {
    const [comparison] = compareWithReference(runWith([22, 44, 30]).workloads[0]!);
    expect(comparison).toMatchObject({ ratio: 1.1, range: [1.1, 1.5], goal: 1.15, isMet: true });
    expect(compareWithReference(runWith([24, 48, 24]).workloads[0]!)[0]?.isMet).toBe(false);
  });
});

describe('formatRun', () => {
  it('says so when a record was lost', () => {
    const run = runWith([22, 44, 22]);
    expect(formatRun(run)).toContain('Everything arrived');
    run.workloads[0]!.rounds['ubii-legacy']![1]!.faults.push('3 records lost');
    expect(faultsOf(run)).toEqual(['round-trip, ubii-legacy, round 2: 3 records lost']);
    expect(formatRun(run)).toContain('do not count');
  });

  it('says so when the machine was busy', () => {
    const run = runWith([22, 44, 22]);
    expect(formatRun(run)).not.toContain('BUSY');
    for (const measurement of run.workloads[0]!.rounds['raw-ws']!) {
      Object.assign(measurement, { otherCpuShare: 0.9 });
    }
    for (const measurement of run.workloads[0]!.rounds['ubii-legacy']!) {
      Object.assign(measurement, { otherCpuShare: 0.9 });
    }
    expect(formatRun(run)).toContain('BUSY');
  });
});

describe('compareRuns', () => {
  it('tells a change from noise', () => {
    const before = runWith([30, 60, 30]);
    expect(compareRuns(before, runWith([22, 44, 22]))).toMatch(/1\.50 .*1\.10 .*-26\.7 % +better/);
    expect(compareRuns(before, runWith([22, 60, 22]))).toContain('within the spread');
  });
});
