/** What crossed between this master and another one so far. */
export interface PeerTotals {
  readonly recordsTo: number;
  readonly recordsFrom: number;
  readonly bytesTo: number;
  readonly bytesFrom: number;
}

/** The same per second. */
export interface RatesOfPeer {
  readonly recordsToPerSecond: number;
  readonly recordsFromPerSecond: number;
  readonly bytesToPerSecond: number;
  readonly bytesFromPerSecond: number;
}

/** Time between two measurements, milliseconds. */
const MEASURE_MS = 2_000;

/** Measures bytes per second between masters. [CU-73] */
export class PeerRates {
  #before: PeerTotals;
  #beforeMs: number;
  #latest: RatesOfPeer = {
    recordsToPerSecond: 0,
    recordsFromPerSecond: 0,
    bytesToPerSecond: 0,
    bytesFromPerSecond: 0,
  };

  /** @param nowMs monotonic milliseconds */
  constructor(totals: PeerTotals, nowMs: number) {
    this.#before = totals;
    this.#beforeMs = nowMs;
  }

  /** Of the last measurement; zeros before the first. */
  get latest(): RatesOfPeer {
    return this.#latest;
  }

  /** To be called often: measures when enough time has passed. */
  measure(totals: PeerTotals, nowMs: number): void {
    const before = this.#before;
    const seconds = (nowMs - this.#beforeMs) / 1_000;
    if (seconds < MEASURE_MS / 1_000) return;
    this.#before = totals;
    this.#beforeMs = nowMs;
    this.#latest = {
      recordsToPerSecond: (totals.recordsTo - before.recordsTo) / seconds,
      recordsFromPerSecond: (totals.recordsFrom - before.recordsFrom) / seconds,
      bytesToPerSecond: (totals.bytesTo - before.bytesTo) / seconds,
      bytesFromPerSecond: (totals.bytesFrom - before.bytesFrom) / seconds,
    };
  }
}
