import type { FlightRecord } from '@ubii/proto';
import { readRecordHead } from '@ubii/proto/wire';

/** Reads what came before; rejects when that cannot be had. */
type Read = (topics: readonly string[]) => Promise<Iterable<FlightRecord>>;

/** Topics of one reading. [RC-36] */
const MAX_TOPICS = 64;

/** Asks for the past of all topics that a page shows at once: the flight recorder is looked through for each reading. */
export class PastRecords {
  readonly #read: Read;
  #waiting = new Set<string>();
  #next: Promise<ReadonlyMap<string, readonly FlightRecord[]>> | undefined;
  #last: Promise<unknown> = Promise.resolve();

  constructor(read: Read) {
    this.#read = read;
  }

  /** @returns the oldest first; none when the past cannot be had */
  async of(topic: string): Promise<readonly FlightRecord[]> {
    this.#waiting.add(topic);
    const found = await (this.#next ??= this.#readNext());
    return found.get(topic) ?? [];
  }

  #readNext(): Promise<ReadonlyMap<string, readonly FlightRecord[]>> {
    const found = this.#last.then(() => this.#readWaiting());
    this.#last = found;
    return found;
  }

  async #readWaiting(): Promise<ReadonlyMap<string, readonly FlightRecord[]>> {
    const topics = [...this.#waiting];
    this.#waiting = new Set();
    this.#next = undefined;
    const found = new Map<string, FlightRecord[]>(topics.map((topic) => [topic, []]));
    for (let at = 0; at < topics.length; at += MAX_TOPICS) {
      const records = await this.#read(topics.slice(at, at + MAX_TOPICS)).catch(() => []);
      for (const past of records) found.get(readRecordHead(past.record).topic)?.push(past);
    }
    return found;
  }
}
