import type { SessionStatistics } from '@ubii/proto';

/** Totals over all modules of a session. */
export interface SessionTotals {
  readonly runsPerSecond: number;
  /** Median run time of the slowest module, milliseconds; `undefined` without runs. */
  readonly p50Ms: number | undefined;
  readonly p95Ms: number | undefined;
  readonly overruns: number;
  readonly errors: number;
  readonly restarts: number;
  readonly refused: number;
  /** Bytes, of the nodes that report them. */
  readonly memoryBytes: number;
}

/** Sums the statistics; for run times takes the slowest module, which determines the latency. */
export function sessionTotals({ modules }: Pick<SessionStatistics, 'modules'>): SessionTotals {
  const sum = (of: (one: (typeof modules)[number]) => number): number =>
    modules.reduce((total, one) => total + of(one), 0);
  const ran = modules.filter(({ runsPerSecond }) => runsPerSecond > 0);
  const slowest = (of: (one: (typeof modules)[number]) => number): number | undefined =>
    ran.length === 0 ? undefined : Math.max(...ran.map(of));
  return {
    runsPerSecond: sum((one) => one.runsPerSecond),
    p50Ms: slowest((one) => one.runP50Ms),
    p95Ms: slowest((one) => one.runP95Ms),
    overruns: sum((one) => one.overruns),
    errors: sum((one) => one.errors),
    restarts: sum((one) => one.restarts),
    refused: sum((one) => one.outputsRefused),
    memoryBytes: sum((one) => one.memoryBytes),
  };
}
