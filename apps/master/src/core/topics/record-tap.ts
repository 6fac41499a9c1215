import { Hook } from '../hooks/hook.ts';
import type { TopicEntry } from './topic-entry.ts';

/** A published record, as the recorder gets it. */
export interface TappedRecord {
  readonly entry: TopicEntry;
  readonly record: Uint8Array;
  /** Id of the client that published; empty for the master. */
  readonly publisherId: string;
  readonly valueField: number;
  /** When it came, epoch milliseconds. */
  readonly timeMs: number;
}

/** Bytes of records from which on they are taken away before their time: what they keep in memory is bounded. */
const MAX_WAITING_BYTES = 4 * 1024 * 1024;

/** Where records of all topics are picked up to be recorded: each costs one reference [RC-50]. */
export class RecordTap {
  isOn = false;
  /** Called with the first record that waits, and when too much waits. */
  readonly onWaiting = new Hook<[isFull: boolean]>();
  #waiting: TappedRecord[] = [];
  #bytes = 0;

  /** Whether nothing waits. */
  get isEmpty(): boolean {
    return this.#waiting.length === 0;
  }

  /** The hot path, called after the record was stored in its entry. */
  take(entry: TopicEntry, record: Uint8Array): void {
    const { publisherId, valueField, publishedMs: timeMs } = entry;
    const length = this.#waiting.push({ entry, record, publisherId, valueField, timeMs });
    this.#bytes += record.byteLength;
    if (length === 1) this.onWaiting.emit(false);
    if (this.#bytes > MAX_WAITING_BYTES) this.onWaiting.emit(true);
  }

  /** Returns what waits, oldest first; it waits no more. */
  drain(): readonly TappedRecord[] {
    const waiting = this.#waiting;
    this.#waiting = [];
    this.#bytes = 0;
    return waiting;
  }
}
