import type { Target, TargetName } from '../brokers/target.ts';
import type { Placement } from '../cpu-placement.ts';
import type { DeliveryFaults } from '../load/delivery-verifier.ts';
import type { RecordRing } from '../load/record-ring.ts';

/** One measured quantity. */
export interface FigureInfo {
  readonly key: string;
  readonly label: string;
  readonly unit: string;
  readonly isHigherBetter: boolean;
  /** Bound of the ratio to raw-ws by target: at most (lower is better) or at least. */
  readonly goals: Partial<Record<TargetName, number>>;
}

export interface MeasureOptions {
  readonly warmUpMs: number;
  readonly measureMs: number;
}

/** One measurement of one target in one round. */
export interface Measurement {
  /** By `FigureInfo.key`. */
  readonly figures: Record<string, number>;
  /** Records delivered while the clock ran. */
  readonly deliveries: number;
  /** CPU time of what else ran on the machine, as a share of the time: 1 is a whole core. */
  readonly otherCpuShare: number;
  /** Everything that was not as it should be; empty is the only good value. */
  readonly faults: string[];
}

/** One row group of the report. */
export interface Workload {
  readonly name: string;
  /** What `npm run bench -- <group>` selects. */
  readonly group: string;
  readonly title: string;
  readonly figures: readonly FigureInfo[];
  readonly placement: Placement;
  createRing(): RecordRing;
  measure(target: Target, ring: RecordRing, options: MeasureOptions): Promise<Measurement>;
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
