import type { Client } from './client.ts';
import type { Traffic } from './traffic.ts';

/** Costs of records, relative to receiving one [EX-27]. */
const WORK = { record: 1, delivery: 0.25, kib: 0.1 };
/** The cost of delivery is split between publisher and subscriber. */
const HALF = 0.5;

/** Counts of one client at the last measurement. */
interface Counted {
  readonly recordsIn: number;
  readonly bytesIn: number;
  readonly recordsCaused: number;
  readonly bytesCaused: number;
  readonly recordsOut: number;
  readonly bytesOut: number;
  readonly throttled: number;
}

const NOTHING: Counted = {
  recordsIn: 0,
  bytesIn: 0,
  recordsCaused: 0,
  bytesCaused: 0,
  recordsOut: 0,
  bytesOut: 0,
  throttled: 0,
};

/** Measures what each client does a second, and its share of the work [EX-26] [EX-27]. */
export class ClientMeter {
  readonly #clients: { values(): Iterable<Client> };
  readonly #before = new WeakMap<Client, Counted>();
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
      const now = countsOf(client);
      const before = this.#before.get(client) ?? NOTHING;
      this.#before.set(client, now);
      const did = (key: keyof Counted): number => now[key] - before[key];
      const { traffic } = client;
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
      sum += traffic.workShare;
    }
    if (sum === 0) return;
    for (const { traffic } of this.#clients.values()) traffic.workShare /= sum;
  }
}

function countsOf(client: Client): Counted {
  const { recordsIn, bytesIn, recordsCaused, bytesCaused }: Traffic = client.traffic;
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
