/** Percentiles of the last round trips of own records, milliseconds. */
export interface EchoLatency {
  readonly lastMs: number;
  readonly p50Ms: number;
  readonly p95Ms: number;
  /** Round trips in the window. */
  readonly count: number;
}

interface Sent {
  readonly timestampMs: number;
  readonly x: number;
  readonly y: number;
  readonly sentAtMs: number;
}

/** Round trips kept: ten seconds of a 60 Hz pointer. */
const WINDOW = 600;
/** Maximum number of records without an echo; older ones count as dropped. */
const MAX_UNDERWAY = 1000;

/**
 * Measures the round-trip time of own records through the master. Records of one publisher on one topic
 * return in order [TD-15], so that records older than an echo count as dropped.
 */
export class EchoLatencyWindow {
  #underway: Sent[] = [];
  #roundTripsMs: number[] = [];

  /** Adds a record that is published at `sentAtMs` of any monotonic clock. */
  sent(record: { timestampMs: number; x: number; y: number }, sentAtMs: number): void {
    if (this.#underway.length >= MAX_UNDERWAY) this.#underway.shift();
    this.#underway.push({ ...record, sentAtMs });
  }

  /** Adds an echo. Returns its round trip in milliseconds; `undefined` for a record of another publisher. */
  returned(
    record: { timestampMs: number | undefined; x: number; y: number },
    returnedAtMs: number,
  ): number | undefined {
    const index = this.#underway.findIndex(
      (sent) =>
        sent.timestampMs === record.timestampMs && sent.x === record.x && sent.y === record.y,
    );
    const sent = this.#underway[index];
    if (sent === undefined) return undefined;
    this.#underway.splice(0, index + 1);
    const roundTripMs = returnedAtMs - sent.sentAtMs;
    if (this.#roundTripsMs.length >= WINDOW) this.#roundTripsMs.shift();
    this.#roundTripsMs.push(roundTripMs);
    return roundTripMs;
  }

  /** Removes all records, as after a reconnect: records without an echo do not return. */
  clear(): void {
    this.#underway = [];
    this.#roundTripsMs = [];
  }

  /** Returns the newest round trips, oldest first, milliseconds. */
  recent(count: number): readonly number[] {
    return this.#roundTripsMs.slice(-count);
  }

  /** `undefined` before the first round trip. */
  summary(): EchoLatency | undefined {
    const lastMs = this.#roundTripsMs.at(-1);
    if (lastMs === undefined) return undefined;
    const sorted = [...this.#roundTripsMs].sort((a, b) => a - b);
    const percentile = (share: number) => sorted[Math.ceil(share * sorted.length) - 1]!;
    return { lastMs, p50Ms: percentile(0.5), p95Ms: percentile(0.95), count: sorted.length };
  }
}
