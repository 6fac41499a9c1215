import type { Client } from './client.ts';
import { NO_RATES, type TrafficCounts } from './traffic.ts';

/** Costs of records, relative to receiving one [EX-27]. */
const WORK = { record: 1, delivery: 0.25, kib: 0.1 };
/** The cost of delivery is split between publisher and subscriber. */
const HALF = 0.5;

/** Measures what each client does a second, and its share of the work [EX-26] [EX-27]. */
export class ClientMeter {
  readonly #clients: { values(): Iterable<Client> };
  #seconds = 0;

  constructor(clients: { values(): Iterable<Client> }) {
    this.#clients = clients;
  }

  /** The time the last measurement covers; 0 before the first. */
  get seconds(): number {
    return this.#seconds;
  }

  /** @param seconds since the call before */
  measure(seconds: number): void {
    this.#seconds = seconds;
    let sum = 0;
    for (const client of this.#clients.values()) {
      if (isIdle(client)) {
        client.traffic.rates = NO_RATES;
        client.traffic.workShare = 0;
      } else {
        sum += measureWork(client, seconds);
      }
    }
    if (sum === 0) return;
    for (const { traffic } of this.#clients.values()) traffic.workShare /= sum;
  }
}

/** Nothing was counted since the last measurement. Most clients are idle: nothing is allocated for them. */
function isIdle({ traffic, subscriber, throttle }: Client): boolean {
  const { measured } = traffic;
  const { outbox } = subscriber;
  return (
    traffic.recordsIn === measured.recordsIn &&
    traffic.bytesIn === measured.bytesIn &&
    traffic.recordsCaused === measured.recordsCaused &&
    traffic.bytesCaused === measured.bytesCaused &&
    outbox.handedRecords === measured.recordsOut &&
    outbox.handedBytes === measured.bytesOut &&
    (throttle?.dropped ?? 0) === measured.throttled
  );
}

/** Sets the rates of a client. @returns its work, which is also set, not yet divided by that of all */
function measureWork(client: Client, seconds: number): number {
  const { traffic } = client;
  const before = traffic.measured;
  const now = countsOf(client);
  const did = (key: keyof TrafficCounts): number => now[key] - before[key];
  traffic.measured = now;
  traffic.rates = {
    recordsInPerSecond: did('recordsIn') / seconds,
    bytesInPerSecond: did('bytesIn') / seconds,
    recordsOutPerSecond: did('recordsOut') / seconds,
    bytesOutPerSecond: did('bytesOut') / seconds,
    throttledPerSecond: Math.max(0, did('throttled')) / seconds,
  };
  const handedRecords = did('recordsCaused') + did('recordsOut');
  const handedBytes = did('bytesCaused') + did('bytesOut');
  traffic.workShare =
    did('recordsIn') * WORK.record +
    did('bytesIn') * (WORK.kib / 1024) +
    HALF * (handedRecords * WORK.delivery + handedBytes * (WORK.kib / 1024));
  return traffic.workShare;
}

function countsOf(client: Client): TrafficCounts {
  const { recordsIn, bytesIn, recordsCaused, bytesCaused } = client.traffic;
  const { handedRecords, handedBytes } = client.subscriber.outbox;
  return {
    recordsIn,
    bytesIn,
    recordsCaused,
    bytesCaused,
    recordsOut: handedRecords,
    bytesOut: handedBytes,
    throttled: client.throttle?.dropped ?? 0,
  };
}
