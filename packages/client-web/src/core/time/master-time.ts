import type { Unsubscribe } from '../callbacks/unsubscribe.ts';

/** Estimate of the master's clock. [TS-4] */
export interface MasterTimeEstimate {
  /** Master's clock minus this machine's, milliseconds: above 0 the master is ahead. */
  readonly offsetMs: number;
  /** Drift of the master's clock against the timer of this machine, parts per million. */
  readonly driftPpm: number;
  /** Bound on the error of `nowMs()`, milliseconds; grows with age until the next measurement. */
  readonly errorMs: number;
  /** When it was measured: milliseconds since the Unix epoch, master's clock. */
  readonly measuredAt: number;
}

/** The master's clock, as a client knows it. [TS-1] */
export interface MasterTime {
  /**
   * Milliseconds since the Unix epoch by the master's clock, with fractions; the clock of this
   * machine before the first measurement. May go back a little when it is measured better.
   */
  nowMs(): number;
  /** As of now; `undefined` before the first measurement, after a sleep until the next one, and with masters that do not tell their time. */
  readonly estimate: MasterTimeEstimate | undefined;
  /** Calls `fn` after every measurement, and with `undefined` when the estimate is no longer valid. */
  onEstimate(fn: (estimate: MasterTimeEstimate | undefined) => void): Unsubscribe;
}
