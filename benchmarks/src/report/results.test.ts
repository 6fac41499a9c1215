import { describe, expect, it } from 'vitest';
import type { Measurement } from '../measuring/workload.ts';
import { compareRuns, formatRun } from './format-results.ts';
import { compareWithReference, faultsOf, type RunResult, type WorkloadResult } from './results.ts';

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

describe('a workload with a reference of its own', () => {
  const [raw] = runWith([22, 44, 22]).workloads;
  const workload: WorkloadResult = {
    ...raw!,
    reference: 'allowed',
    figures: [
      { key: 'p50Us', label: 'p50', unit: 'µs', isHigherBetter: false, goals: { module: 1 } },
      {
        key: 'late',
        label: 'late',
        unit: 'ms',
        isHigherBetter: false,
        goals: {},
        bounds: { module: 2 },
      },
    ],
    rounds: {
      allowed: rounds([20, 40, 20]),
      module: rounds([30, 50, 30]).map((round) => ({
        ...round,
        figures: { ...round.figures, late: 1.5 },
      })),
    },
  };

  it('is judged by it, and by bounds where a ratio says nothing', () => {
    expect(compareWithReference(workload)).toMatchObject([
      { target: 'module', ratio: 1.5, goal: 1, isMet: false },
      { target: 'module', value: 1.5, bound: 2, isMet: true },
    ]);
  });

  it('is judged by the rounds that could be measured', () => {
    const failed = { figures: {}, deliveries: 0, otherCpuShare: 0, faults: ['it did not start'] };
    const { allowed = [], module = [] } = workload.rounds;
    const partly = { ...workload, rounds: { allowed, module: [failed, ...module.slice(1)] } };
    expect(compareWithReference(partly)[0]).toMatchObject({
      ratio: 1.375,
      range: [1.25, 1.5],
      value: 40,
    });
  });

  it('shows no ratio where the reference has no such figure', () => {
    const text = formatRun({ ...runWith([22, 44, 22]), workloads: [workload] });
    expect(text).toMatch(/p50 +module +1\.50 +<= 1 +MISS/);
    expect(text).toMatch(/late +module +<= 2 ms +pass +1\.5/);
    expect(text).not.toContain('NaN');
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
