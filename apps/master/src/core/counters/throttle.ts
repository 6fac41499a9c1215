/** Limit on the records that a client publishes [EX-31]. */
export interface Throttle {
  readonly recordsPerSecond: number;
  /** Made, and to be lifted, by the policy of the master [EX-48]. */
  readonly byPolicy: boolean;
  /** Name of the client that requested it; empty when unknown. */
  readonly byName: string;
  /** The reason; empty when none was given. */
  readonly reason: string;
  /** Epoch milliseconds. */
  readonly sinceMs: number;
  /** Records that were dropped because of it. */
  dropped: number;
}

/** The throttle as people read it: `throttled to 10 records per second by Mara: too loud`. */
export function describeThrottle({
  recordsPerSecond,
  byPolicy,
  byName,
  reason,
}: Omit<Throttle, 'dropped'>): string {
  const who = byPolicy ? ' by the policy of the master' : byName === '' ? '' : ` by ${byName}`;
  const why = reason === '' ? '' : `: ${reason}`;
  return `throttled to ${recordsPerSecond} records per second${who}${why}`;
}
