import type { Cancel, Clock } from '@ubii/timing';

/**
 * Lets the newest record of each topic through, at most so often. One that comes too early waits,
 * and is replaced by a newer one. The master limits too (TD-28), but for the client as a whole, and
 * an original master does not.
 */
export class RateLimit<T extends { readonly topic: string }> {
  readonly #clock: Clock;
  readonly #intervalMs: number;
  readonly #deliver: (record: T) => void;
  readonly #topics = new Map<string, { waiting: T | undefined; cancel: Cancel }>();

  /** @throws {RangeError} if the rate is not above 0 */
  constructor(clock: Clock, maxRateHz: number, deliver: (record: T) => void) {
    if (!(maxRateHz > 0)) {
      throw new RangeError(`Expected a rate above 0 Hz, received ${maxRateHz}`);
    }
    this.#clock = clock;
    this.#intervalMs = 1000 / maxRateHz;
    this.#deliver = deliver;
  }

  handle(record: T): void {
    const topic = this.#topics.get(record.topic);
    if (topic === undefined) {
      this.#open(record);
    } else {
      topic.waiting = record;
    }
  }

  close(): void {
    for (const { cancel } of this.#topics.values()) cancel();
    this.#topics.clear();
  }

  /** Delivers, and closes the topic for one interval; a topic on which nothing waits then is forgotten. */
  #open(record: T): void {
    const topic = {
      waiting: undefined as T | undefined,
      cancel: this.#clock.after(this.#intervalMs, () => this.#handleInterval(record.topic)),
    };
    this.#topics.set(record.topic, topic);
    this.#deliver(record);
  }

  #handleInterval(name: string): void {
    const waiting = this.#topics.get(name)?.waiting;
    this.#topics.delete(name);
    if (waiting !== undefined) this.#open(waiting);
  }
}
