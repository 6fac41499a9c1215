/** Offset of the master's clock relative to this computer's. */
export interface ClockOffset {
  /** Add it to this computer's clock to get the master's, milliseconds. */
  readonly offsetMs: number;
  /** Bound on the error of the offset, milliseconds: half the round trip. */
  readonly errorMs: number;
  /** Time of the measurement, this computer's clock, epoch milliseconds. */
  readonly measuredMs: number;
}

/** Largest drift of ordinary clocks, milliseconds per second. */
const DRIFT_MS_PER_S = 0.1;

/**
 * Returns the better one of the known and a new measurement. A measurement with a short round trip stays until drift
 * makes it worse than the new one.
 * @param sentMs and `receivedMs`: this computer's clock · `masterMs`: the master's, in between
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
