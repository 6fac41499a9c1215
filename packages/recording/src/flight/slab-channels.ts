import type { SlabChannel } from './slab.ts';

/** Numbers for topics and publishers, as long as records in slabs have them. */
export class SlabChannels {
  readonly #numbers = new Map<string, Map<string, number>>();
  readonly #channels = new Map<number, SlabChannel>();
  readonly #records = new Map<number, number>();
  #next = 0;

  /** Topics that have records. */
  get topics(): Iterable<string> {
    return this.#numbers.keys();
  }

  hasTopic(topic: string): boolean {
    return this.#numbers.has(topic);
  }

  /** The number of a channel that gets a record. */
  take({ topic, clientId }: SlabChannel): number {
    let byClient = this.#numbers.get(topic);
    if (byClient === undefined) this.#numbers.set(topic, (byClient = new Map<string, number>()));
    let number = byClient.get(clientId);
    if (number === undefined) {
      number = this.#next++;
      byClient.set(clientId, number);
      this.#channels.set(number, { topic, clientId });
    }
    this.#records.set(number, (this.#records.get(number) ?? 0) + 1);
    return number;
  }

  get(number: number): SlabChannel {
    return this.#channels.get(number)!;
  }

  /** Tells that a channel lost a record. */
  release(number: number): void {
    const left = this.#records.get(number)! - 1;
    this.#records.set(number, left);
    if (left > 0) return;
    const { topic, clientId } = this.get(number);
    const byClient = this.#numbers.get(topic)!;
    byClient.delete(clientId);
    if (byClient.size === 0) this.#numbers.delete(topic);
    this.#channels.delete(number);
    this.#records.delete(number);
  }

  /** The channels as they are now, by number. */
  snapshot(): ReadonlyMap<number, SlabChannel> {
    return new Map(this.#channels);
  }
}
