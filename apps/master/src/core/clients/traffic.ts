/** Rates of a client per second, over the last measurement. */
export interface TrafficRates {
  readonly recordsInPerSecond: number;
  readonly bytesInPerSecond: number;
  readonly recordsOutPerSecond: number;
  readonly bytesOutPerSecond: number;
  /** Records a second that a throttle kept back. */
  readonly throttledPerSecond: number;
}

/** Of a client that does nothing. */
export const NO_RATES: TrafficRates = {
  recordsInPerSecond: 0,
  bytesInPerSecond: 0,
  recordsOutPerSecond: 0,
  bytesOutPerSecond: 0,
  throttledPerSecond: 0,
};

/** What a client did and got since its registration, as the measurement of rates sees it. */
export interface TrafficCounts {
  readonly recordsIn: number;
  readonly bytesIn: number;
  readonly recordsCaused: number;
  readonly bytesCaused: number;
  readonly recordsOut: number;
  readonly bytesOut: number;
  /** Of the throttle that holds: lower than before when it was lifted. */
  readonly throttled: number;
}

const NO_COUNTS: TrafficCounts = {
  recordsIn: 0,
  bytesIn: 0,
  recordsCaused: 0,
  bytesCaused: 0,
  recordsOut: 0,
  bytesOut: 0,
  throttled: 0,
};

/** Counters of one client since its registration. Plain numbers, because the record path adds to them [EX-26]. */
export class Traffic {
  recordsIn = 0;
  bytesIn = 0;
  /** Records of its own that were given to subscribers, once for each. */
  recordsCaused = 0;
  bytesCaused = 0;
  refused = 0;
  rates = NO_RATES;
  /** At the last measurement of its rates. */
  measured = NO_COUNTS;
  /** [EX-27] */
  workShare = 0;
}
