import type { SessionStatistics } from '@ubii/proto';

/** What all modules of a session do together. */
export interface SessionTotals {
  readonly runsPerSecond: number;
  /** Of the slowest module, milliseconds; `undefined` when nothing ran. */
  readonly p50Ms: number | undefined;
  readonly p95Ms: number | undefined;
  readonly overruns: number;
  readonly errors: number;
  readonly restarts: number;
  readonly refused: number;
  /** Bytes, as far as nodes know. */
  readonly memoryBytes: number;
}

/** Sums what can be summed; of run times the slowest counts, for it is what people feel. */
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
