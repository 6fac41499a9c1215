import type { Account } from '../shares/account.ts';
import { RESOURCE } from '../shares/resources.ts';
import type { TopicEntry } from './topic-entry.ts';

interface WaitingRecord {
  readonly record: Uint8Array;
  readonly isEvent: boolean;
  readonly stamp: number;
}

/** One record taken out of the queue. */
export interface TakenRecord extends WaitingRecord {
  readonly entry: TopicEntry;
}

/** Limits of a queue, and a callback for dropped records. */
export interface WaitingBounds {
  /** Pays for what waits, and bounds it [AC-80]. */
  readonly account: Account;
  readonly maxEventsPerTopic: number;
  /** A record of this topic was dropped, because a newer one came or for want of room. */
  readonly onDropped: (entry: TopicEntry) => void;
}

/**
 * The records of one client that wait for its socket. Of a state only the newest waits; events all do
 * [TD-31] [TD-32]. Topics take turns, one record each, beginning with the one that waits longest.
 */
export class WaitingRecords {
  readonly #bounds: WaitingBounds;
  readonly #topics = new Map<TopicEntry, WaitingRecord[]>();
  #byteLength = 0;
  #count = 0;

  constructor(bounds: WaitingBounds) {
    this.#bounds = bounds;
  }

  get byteLength(): number {
    return this.#byteLength;
  }

  get count(): number {
    return this.#count;
  }

  /** Topics with a waiting record, longest waiting first. */
  topics(): Iterable<TopicEntry> {
    return this.#topics.keys();
  }

  /** Whether a record of this topic waits; then its newest does. */
  has(entry: TopicEntry): boolean {
    return this.#topics.has(entry);
  }

  push(entry: TopicEntry, record: Uint8Array, isEvent: boolean, stamp = entry.stamp): void {
    let waiting = this.#topics.get(entry);
    if (waiting === undefined) {
      waiting = [];
      this.#topics.set(entry, waiting);
    }
    const newest = waiting.at(-1);
    if (newest !== undefined && !newest.isEvent && !isEvent) {
      waiting.pop();
      this.#dropped(entry, newest);
    } else if (waiting.length >= this.#bounds.maxEventsPerTopic) {
      this.#dropped(entry, waiting.shift()!);
    }
    waiting.push({ record, isEvent, stamp });
    this.#count++;
    this.#grow(record.byteLength);
    const { account } = this.#bounds;
    while (this.#count > 1 && account.shortage(RESOURCE.queueBytes, 0) !== undefined) {
      this.#dropOldest();
    }
  }

  /** The record whose turn it is, removed from the queue. */
  take(): TakenRecord | undefined {
    for (const [entry, waiting] of this.#topics) {
      const taken = waiting.shift()!;
      this.#topics.delete(entry);
      // To the end of the line, or a topic with many events would starve the others.
      if (waiting.length > 0) this.#topics.set(entry, waiting);
      this.#grow(-taken.record.byteLength);
      this.#count--;
      return { entry, ...taken };
    }
    return undefined;
  }

  /** Drops what waits of a topic. */
  drop(entry: TopicEntry): void {
    for (const waiting of this.#topics.get(entry) ?? []) this.#dropped(entry, waiting);
    this.#topics.delete(entry);
  }

  clear(): void {
    this.#topics.clear();
    this.#grow(-this.#byteLength);
    this.#count = 0;
  }

  #grow(bytes: number): void {
    this.#byteLength += bytes;
    this.#bounds.account.add(RESOURCE.queueBytes, bytes);
  }

  #dropOldest(): void {
    for (const [entry, waiting] of this.#topics) {
      this.#dropped(entry, waiting.shift()!);
      if (waiting.length === 0) this.#topics.delete(entry);
      return;
    }
  }

  #dropped(entry: TopicEntry, dropped: WaitingRecord): void {
    this.#grow(-dropped.record.byteLength);
    this.#count--;
    this.#bounds.onDropped(entry);
  }
}
