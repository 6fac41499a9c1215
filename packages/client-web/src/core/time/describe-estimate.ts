import type { MasterTimeEstimate } from './master-time.ts';

/** The numbers that tell the master of this client's clock: offset, error and drift; empty when there is none. [TS-10] */
export function describeEstimate(estimate: MasterTimeEstimate | undefined): string {
  if (estimate === undefined) return '';
  const { offsetMs, errorMs, driftPpm } = estimate;
  return `${offsetMs.toFixed(3)} ${errorMs.toFixed(3)} ${driftPpm.toFixed(1)}`;
}
