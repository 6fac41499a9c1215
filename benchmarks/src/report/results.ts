import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { dirname } from 'node:path';

import { REFERENCE } from '../brokers/target.ts';
import type { FigureInfo, Measurement } from '../measuring/workload.ts';
import { median, ratiosOf } from '../statistics.ts';

/** Result of one workload: per target one measurement a round, in the order of the rounds. */
export interface WorkloadResult {
  readonly name: string;
  readonly title: string;
  readonly figures: readonly FigureInfo[];
  /** The subject all others are divided by; absent in files of earlier versions, where it was raw-ws. */
  readonly reference?: string;
  readonly rounds: Readonly<Record<string, Measurement[]>>;
}

/** One run of `npm run bench`, as it is written to disk. */
export interface RunResult {
  readonly formatVersion: 1;
  readonly startedAt: string;
  readonly machine: {
    readonly node: string;
    readonly cores: number;
    readonly cpu: string;
    /** Load average of the last minute, before and after. */
    readonly loadAverage: readonly [before: number, after: number];
    /** False where `taskset` is missing: round trips then depend on where the system puts processes. */
    readonly isPlaced: boolean;
  };
  /** Commit of the working tree; `isDirty` when it had changes that are not in it. */
  readonly commit: { readonly hash: string; readonly isDirty: boolean };
  readonly parameters: {
    readonly rounds: number;
    readonly warmUpMs: number;
    readonly measureMs: number;
  };
  readonly workloads: readonly WorkloadResult[];
}

/** One line of the report: a figure of a target beside the reference. */
export interface Comparison {
  readonly figure: FigureInfo;
  readonly target: string;
  /** Median over the rounds of value / reference of the same round. */
  readonly ratio: number;
  /** Smallest and largest ratio of a round. */
  readonly range: readonly [number, number];
  readonly goal: number | undefined;
  /** Bound of the value itself; counts where there is no goal. */
  readonly bound: number | undefined;
  /** Undefined without a goal and a bound. */
  readonly isMet: boolean | undefined;
  readonly value: number;
  readonly reference: number;
}

/** The values of one figure, one a round. */
export function valuesOf(
  result: WorkloadResult,
  target: string,
  figure: FigureInfo,
): readonly number[] {
  const rounds = result.rounds[target] ?? [];
  return rounds.map(({ figures }) => figures[figure.key] ?? Number.NaN);
}

/** Compares every target of a workload with the reference, figure by figure. */
export function compareWithReference(result: WorkloadResult): Comparison[] {
  const referenceName = referenceOf(result);
  const targets = Object.keys(result.rounds).filter((name) => name !== referenceName);
  return result.figures.flatMap((figure) => {
    const references = valuesOf(result, referenceName, figure);
    if (references.length === 0) return [];
    return targets.flatMap((target): Comparison[] => {
      const values = valuesOf(result, target, figure);
      // Not every figure makes sense for every subject.
      if (values.every(Number.isNaN)) return [];
      // A round that failed, or a reference of 0, has no ratio.
      const ratios = ratiosOf(values, references).filter(Number.isFinite);
      const ratio = median(ratios);
      const goal = figure.goals[target];
      const bound = figure.bounds?.[target];
      const middle = median(values.filter(Number.isFinite));
      return [
        {
          figure,
          target,
          ratio,
          range: [Math.min(...ratios), Math.max(...ratios)],
          goal,
          bound,
          isMet:
            goal !== undefined
              ? isWithin(figure, ratio, goal)
              : bound !== undefined
                ? isWithin(figure, middle, bound)
                : undefined,
          value: middle,
          reference: median(references.filter(Number.isFinite)),
        },
      ];
    });
  });
}

/** Name of the subject the others are divided by. */
export function referenceOf({ reference }: WorkloadResult): string {
  return reference ?? REFERENCE;
}

function isWithin({ isHigherBetter }: FigureInfo, value: number, bound: number): boolean {
  return isHigherBetter ? value >= bound : value <= bound;
}

/** Cores that other processes used while it was measured: median and largest. */
export function otherCpuOf(result: RunResult): { median: number; max: number } {
  const shares = result.workloads
    .flatMap(({ rounds }) => Object.values(rounds))
    .flatMap((measurements) => measurements.map(({ otherCpuShare }) => otherCpuShare));
  return { median: median(shares), max: Math.max(...shares) };
}

/** Lost, altered or unexpected records anywhere in the run, one sentence each. */
export function faultsOf(result: RunResult): string[] {
  return result.workloads.flatMap(({ name, rounds }) =>
    Object.entries(rounds).flatMap(([target, measurements]) =>
      measurements.flatMap(({ faults }, round) =>
        faults.map((fault) => `${name}, ${target}, round ${round + 1}: ${fault}`),
      ),
    ),
  );
}

/** Writes a run as JSON, with its directory. */
export async function writeRun(path: string, run: RunResult): Promise<void> {
  await mkdir(dirname(path), { recursive: true });
  await writeFile(path, `${JSON.stringify(run, null, 2)}\n`);
}

/**
 * Reads a run that `writeRun` wrote.
 *
 * @throws Error with one sentence when there is none at `path`.
 */
export async function readRun(path: string): Promise<RunResult> {
  let text: string;
  try {
    text = await readFile(path, 'utf8');
  } catch {
    throw new Error(`There is no readable file ${path}.`);
  }
  let run: Partial<RunResult> | null;
  try {
    run = JSON.parse(text) as Partial<RunResult> | null;
  } catch {
    throw new Error(`${path} is not JSON.`);
  }
  if (run?.formatVersion !== 1) throw new Error(`${path} is no benchmark result of format 1.`);
  return run as RunResult;
}
