import type { Placement } from '../cpu-placement.ts';
import type { DeliveryFaults } from '../load/delivery-verifier.ts';
import type { SharedParts } from '../parts/shared-parts.ts';

/** One measured quantity. */
export interface FigureInfo {
  readonly key: string;
  readonly label: string;
  readonly unit: string;
  readonly isHigherBetter: boolean;
  /** Bound of the ratio to the reference, by subject: at most (lower is better) or at least. */
  readonly goals: Readonly<Record<string, number>>;
  /** Bound of the value itself, by subject, where a ratio says nothing. */
  readonly bounds?: Readonly<Record<string, number>>;
}

export interface MeasureOptions {
  readonly warmUpMs: number;
  readonly measureMs: number;
}

/** One measurement of one subject in one round. */
export interface Measurement {
  /** By `FigureInfo.key`. */
  readonly figures: Readonly<Record<string, number>>;
  /** Records delivered, or calls answered, while the clock ran. */
  readonly deliveries: number;
  /** CPU time of what else ran on the machine, as a share of the time: 1 is a whole core. */
  readonly otherCpuShare: number;
  /** Everything that was not as it should be; empty is the only good value. */
  readonly faults: string[];
  /** What else there is to say, a line each. Default: nothing */
  readonly notes?: readonly string[];
}

/** One of the implementations that a workload measures and compares. */
export interface Subject {
  readonly name: string;
  /** Processes whose CPU time is counted, and that are placed, besides this one. */
  readonly pids: readonly number[];
  measure(options: MeasureOptions): Promise<Measurement>;
}

/** Settings of all workloads, from the command line. */
export interface WorkloadSetting {
  /** Parts shared by the workloads of a group, until the next start. */
  readonly parts: SharedParts;
  /** Main file of the master to measure. */
  readonly master: string;
  /** Directory for CPU profiles. */
  readonly profileDir: string | undefined;
}

/** One row group of the report. */
export interface Workload {
  readonly name: string;
  /** Name of the group in `npm run bench -- <group>`. */
  readonly group: string;
  readonly title: string;
  readonly figures: readonly FigureInfo[];
  /** Name of the subject all others are divided by. */
  readonly reference: string;
  readonly placement: Placement;
  /** Share of the rounds it takes part in, where it has many subjects or steady figures. */
  readonly roundShare: number;
  /** Why it cannot be measured here; undefined: it can. */
  whyNot?(): string | undefined;
  /** Starts what is to be measured. */
  open(setting: WorkloadSetting): Promise<readonly Subject[]>;
  /** A further subject that is computed from those of a round, such as a sum of two. */
  derive?(round: Readonly<Record<string, Measurement>>): Record<string, Measurement>;
}

/** The faults of all connections as sentences, numbers added up. */
export function describeFaults(all: Iterable<DeliveryFaults>): string[] {
  let lost = 0;
  let altered = 0;
  let repeated = 0;
  const unexpected = new Set<string>();
  for (const faults of all) {
    lost += faults.lost;
    altered += faults.altered;
    repeated += faults.repeated;
    for (const sentence of faults.unexpected) unexpected.add(sentence);
  }
  return [
    ...(lost > 0 ? [`${lost} records lost`] : []),
    ...(altered > 0 ? [`${altered} records altered`] : []),
    ...(repeated > 0 ? [`${repeated} records repeated or out of order`] : []),
    ...[...unexpected].map((sentence) => `unexpected: ${sentence}`),
  ];
}

/** The figure has to fall by this share for the subject to count as not yet warm. */
const GAIN = 0.05;
/** Measurements without such a gain, one after the other, after which the subject is warm. */
const STEADY_COUNT = 3;
const MAX_COUNT = 20;
const LONGEST_MS = 1_000;

/**
 * The same subject, warm: before its first measurement, it is measured again and again until a figure does not fall any
 * more. V8 compiles what runs often, which takes seconds at a few hundred calls a second.
 *
 * @param key of a figure that is better when it is lower
 */
export function warmed(subject: Subject, key: string): Subject {
  let warming: Promise<string[]> | undefined = undefined;
  return {
    ...subject,
    measure: async (options) => {
      const faults = await (warming ??= warmUp(subject, key, options));
      warming = Promise.resolve([]);
      const measurement = await subject.measure(options);
      return { ...measurement, faults: [...faults, ...measurement.faults] };
    },
  };
}

/** @returns what went wrong, each once: a record that is lost while it warms up is lost */
async function warmUp(subject: Subject, key: string, options: MeasureOptions): Promise<string[]> {
  const measureMs = Math.min(options.measureMs, LONGEST_MS);
  const faults = new Set<string>();
  let least = Number.POSITIVE_INFINITY;
  let steadyCount = 0;
  for (let count = 0; count < MAX_COUNT && steadyCount < STEADY_COUNT; count += 1) {
    const measurement: Measurement = await subject.measure({ ...options, measureMs });
    for (const fault of measurement.faults) faults.add(fault);
    const value = measurement.figures[key] ?? Number.NaN;
    if (value < least * (1 - GAIN)) steadyCount = 0;
    else steadyCount += 1;
    if (value < least) least = value;
  }
  return [...faults];
}
