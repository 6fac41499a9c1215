import type { Clock, UbiiClient } from '@ubii/client-web';

import type { PhoneDelay } from '../../modules/index.ts';
import { WAIT_FOR_LATE_MS } from '../../sim/index.ts';

/** One measurement of the master. */
export interface MeasuredRoundTrip {
  /** From a PING of the master to its answer, milliseconds; 0: none was measured. */
  readonly roundTripMs: number;
  readonly measuredAtMs: number;
}

/** As long as clients keep their measurements of the clock (TS-4). */
const WINDOW_MS = 60_000;
const FORGET_MS = 120_000;
/** Phones that are remembered: more than can play. */
const MAX_PHONES = 256;
/** The time of a measurement is computed from its age, which the way of the report makes uncertain. */
const SAME_MS = 250;
/** Steps in which browsers and master read their clocks, and the drift between two measurements. */
const SLACK_MS = 4;
/** Half of all packets are later than the median: so many times the distance from the least to it. */
const SPREAD = 2;

/** Of fewer measurements, all may be slower than the line is. */
const ENOUGH = 3;

interface RoundTrips {
  readonly leastMs: number;
  readonly medianMs: number;
  readonly count: number;
}

/** Delays of the phones from round trips measured by the master; a phone's own claims are not used. */
export class PhoneDelays {
  readonly #measured = new Map<string, MeasuredRoundTrip[]>();

  record(key: string, { roundTripMs, measuredAtMs }: MeasuredRoundTrip): void {
    if (!(roundTripMs > 0) || !Number.isFinite(measuredAtMs)) return;
    for (const [one, samples] of this.#measured)
      if (samples.at(-1)!.measuredAtMs < measuredAtMs - FORGET_MS) this.#measured.delete(one);
    const samples = this.#measured.get(key) ?? [];
    if (samples.length === 0 && this.#measured.size >= MAX_PHONES) return;
    if (Math.abs((samples.at(-1)?.measuredAtMs ?? -Infinity) - measuredAtMs) < SAME_MS) return;
    const isOfNow = (one: MeasuredRoundTrip): boolean =>
      one.measuredAtMs > measuredAtMs - WINDOW_MS;
    this.#measured.set(key, [...samples.filter(isOfNow), { roundTripMs, measuredAtMs }]);
  }

  /** The median round trip, milliseconds; undefined before the first. */
  lagOf(key: string): number | undefined {
    return this.#roundTrips(key)?.medianMs;
  }

  /**
   * Bounds of the delay between the time that a phone claims for a press and its arrival. An estimate of the master's
   * clock is off by at most half the difference between the two directions (TS-4): by that clock, one direction takes
   * half of the round trip, whichever is longer.
   */
  of(key: string): PhoneDelay | undefined {
    const roundTrips = this.#roundTrips(key);
    if (!roundTrips) return undefined;
    const { leastMs, medianMs, count } = roundTrips;
    const mostMs = medianMs / 2 + SPREAD * (medianMs - leastMs) + SLACK_MS;
    const bounded = Math.min(WAIT_FOR_LATE_MS, Math.ceil(mostMs));
    return {
      leastMs:
        count < ENOUGH ? 0 : Math.min(bounded, Math.max(0, Math.floor(leastMs / 2 - SLACK_MS))),
      mostMs: bounded,
    };
  }

  #roundTrips(key: string): RoundTrips | undefined {
    const sorted = (this.#measured.get(key) ?? [])
      .map(({ roundTripMs }) => roundTripMs)
      .sort((a, b) => a - b);
    const [leastMs] = sorted;
    // An even number: the larger one, so that two measurements show a spread
    const medianMs = sorted[Math.floor(sorted.length / 2)];
    return leastMs === undefined || medianMs === undefined
      ? undefined
      : { leastMs, medianMs, count: sorted.length };
  }
}

/** The master measures each client at least every 5 s (CL-12). */
const ASK_MS = 2000;

interface DelayWatchOptions {
  readonly client: UbiiClient;
  readonly clock: Clock;
  /** Clients of the phones that play now. */
  keys(): readonly string[];
}

/** Asks the master for the round trips that it measured. */
export class DelayWatch {
  readonly delays = new PhoneDelays();
  readonly #options: DelayWatchOptions;

  constructor(options: DelayWatchOptions) {
    this.#options = options;
  }

  /** @returns ends it */
  start(): () => void {
    return this.#options.clock.every(ASK_MS, () => void this.#ask());
  }

  async #ask(): Promise<void> {
    const clientIds = [...this.#options.keys()];
    if (clientIds.length === 0) return;
    try {
      const { clients, masterTimeMs } = await this.#options.client.call('clientReport', {
        clientIds,
      });
      for (const { clientId, roundTripMs, roundTripAgeMs } of clients)
        this.delays.record(clientId, { roundTripMs, measuredAtMs: masterTimeMs - roundTripAgeMs });
    } catch {
      // Not connected, or not allowed: the earlier measurements stay
    }
  }
}
