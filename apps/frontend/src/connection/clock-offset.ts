/** How far the master's clock is ahead of this machine's. */
export interface ClockOffset {
  /** Add it to this machine's clock to get the master's, milliseconds. */
  readonly offsetMs: number;
  /** The true offset lies within this, milliseconds: half the time the question was on its way. */
  readonly errorMs: number;
  /** When it was measured, this machine's clock, epoch milliseconds. */
  readonly measuredMs: number;
}

/** Clocks of ordinary machines drift apart by at most about this much, milliseconds per second. */
const DRIFT_MS_PER_S = 0.1;

/**
 * The better of what is known and a new measurement. A quick answer is a good measurement and stands
 * until drift has made it worse than the new one.
 * @param sentMs and `receivedMs`: this machine's clock · `masterMs`: the master's, in between
 */
export function measureClock(
  known: ClockOffset | undefined,
  sentMs: number,
  receivedMs: number,
  masterMs: number,
): ClockOffset {
  const errorMs = Math.max(0, receivedMs - sentMs) / 2;
  const fresh = { offsetMs: masterMs - (sentMs + receivedMs) / 2, errorMs, measuredMs: receivedMs };
  if (known === undefined) return fresh;
  const ageS = (receivedMs - known.measuredMs) / 1000;
  return errorMs <= known.errorMs + ageS * DRIFT_MS_PER_S ? fresh : known;
}
