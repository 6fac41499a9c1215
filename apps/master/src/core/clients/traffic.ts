/** Rates of a client per second, over the last measurement. */
export interface TrafficRates {
  readonly recordsInPerSecond: number;
  readonly bytesInPerSecond: number;
  readonly recordsOutPerSecond: number;
  readonly bytesOutPerSecond: number;
  /** Records a second that a throttle kept back. */
  readonly throttledPerSecond: number;
}

const NO_RATES: TrafficRates = {
  recordsInPerSecond: 0,
  bytesInPerSecond: 0,
  recordsOutPerSecond: 0,
  bytesOutPerSecond: 0,
  throttledPerSecond: 0,
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
  /** [EX-27] */
  workShare = 0;
}
