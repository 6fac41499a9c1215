/** Time from a PING of ours to the master's PONG, milliseconds, over the last 60. Masters of ours only. */
export interface RoundTrip {
  readonly lastMs: number;
  readonly p50Ms: number;
  readonly p95Ms: number;
}
