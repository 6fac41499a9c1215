import type { BridgeReport, LaneReport } from './bridge-report.ts';

/** Bridges report each second in which something changed: a longer pause was one without records. */
const INTERVAL_MS = 1_000;
/** Without a report for this time, nothing passes any more. */
const STALE_MS = 2_500;

/** Records per second of one mapping or of all. */
export interface DirectionRates {
  readonly in: number;
  readonly out: number;
}

/** A report and when it came, milliseconds of this computer's monotonic clock. */
export interface TimedReport {
  readonly report: BridgeReport;
  readonly atMs: number;
}

export const NO_RATES: DirectionRates = { in: 0, out: 0 };

/** Rates between two reports of a bridge, by name of the mapping. */
export function ratesBetween(
  before: TimedReport | undefined,
  after: TimedReport,
): ReadonlyMap<string, DirectionRates> {
  if (before === undefined) return new Map();
  const seconds = Math.min(Math.max(after.atMs - before.atMs, 1), INTERVAL_MS * 1.5) / 1000;
  const known = new Map(before.report.mappings.map((mapping) => [mapping.name, mapping]));
  const rate = (now: LaneReport | undefined, then: LaneReport | undefined): number => {
    if (now === undefined || then === undefined) return 0;
    // Counters that went back were started again.
    return Math.max(0, now.passed - then.passed) / seconds;
  };
  return new Map(
    after.report.mappings.map((mapping) => {
      const then = known.get(mapping.name);
      return [mapping.name, { in: rate(mapping.in, then?.in), out: rate(mapping.out, then?.out) }];
    }),
  );
}

/** Rates of all mappings together. */
export function sumRates(rates: Iterable<DirectionRates>): DirectionRates {
  let sum = NO_RATES;
  for (const one of rates) sum = { in: sum.in + one.in, out: sum.out + one.out };
  return sum;
}

/** False when the rates of a report do not hold any more. */
export function isFresh({ atMs }: TimedReport, nowMs: number): boolean {
  return nowMs - atMs < STALE_MS;
}
