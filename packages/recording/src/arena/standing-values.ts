import type { Channel } from './channels.ts';

/** Larger values are not kept once they left the window. */
const MAX_RECORD_BYTES = 16 * 1024;

/** A value that stands when the window begins. */
export interface StandingValue {
  readonly timeMs: number;
  readonly record: Uint8Array<ArrayBuffer>;
}

/** The last value of each topic and publisher that left the window: what stands when the window begins. [RC-33] */
export class StandingValues {
  readonly #values = new Map<Channel, StandingValue>();
  #bytes = 0;

  get bytes(): number {
    return this.#bytes;
  }

  has(channel: Channel): boolean {
    return this.#values.has(channel);
  }

  /** Keeps a copy in place of an earlier value. @param record of any memory */
  set(channel: Channel, timeMs: number, record: Uint8Array): void {
    this.delete(channel);
    if (record.length > MAX_RECORD_BYTES) return;
    this.#values.set(channel, { timeMs, record: record.slice() });
    this.#bytes += bytesOf(channel, record.length);
  }

  delete(channel: Channel): void {
    const known = this.#values.get(channel);
    if (known === undefined) return;
    this.#values.delete(channel);
    this.#bytes -= bytesOf(channel, known.record.length);
  }

  /** Forgets the values that were kept first. @returns their channels */
  *limitTo(bytes: number): Generator<Channel> {
    for (const channel of this.#values.keys()) {
      if (this.#bytes <= bytes) return;
      this.delete(channel);
      yield channel;
    }
  }

  [Symbol.iterator](): IterableIterator<[Channel, StandingValue]> {
    return this.#values.entries();
  }
}

/** With what map and objects take, about. */
function bytesOf({ topic }: Channel, recordBytes: number): number {
  return 256 + topic.length * 2 + recordBytes;
}
