import { within, type Cancel } from '@ubii/timing';

import { reasonOf } from './explain-nats-error.ts';
import type { KvBucket } from './kv-bucket.ts';
import { watchBucket, type WatchedEntry } from './kv-watch.ts';
import type { NatsLink } from './nats-link.ts';

/** Time before a bucket that could not be watched is tried again, milliseconds. */
const RETRY_MS = 500;

/** The side that a follower tells. */
export interface FollowerListener {
  /** All values are told from the beginning. @param isAnew the bucket is another one than before, with other revisions */
  handleBegin(isAnew: boolean): void;
  handleEntry(entry: WatchedEntry): void;
  /** All values that were there have been told since `handleBegin`. */
  handleComplete(): void;
}

/** Watches a bucket, again from the beginning whenever NATS comes back or anything was missed. */
export class BucketFollower {
  readonly #link: NatsLink;
  readonly #bucket: KvBucket;
  readonly #listener: FollowerListener;
  readonly #cancelReach: Cancel;
  /** Of the watch in force; what earlier ones tell is ignored. */
  #turn = 0;
  #cancelWatch: Cancel = () => undefined;
  #created: string | undefined;
  #isClosed = false;
  #lastError: unknown = new Error('NATS does not answer');
  #resolveFirst: () => void = () => undefined;

  constructor(link: NatsLink, bucket: KvBucket, listener: FollowerListener) {
    this.#link = link;
    this.#bucket = bucket;
    this.#listener = listener;
    this.#cancelReach = link.onReach((isConnected) => {
      if (isConnected) this.#begin();
      else this.#leave();
    });
  }

  /** Starts. Resolves after all entries of the bucket were delivered. @throws the last error after a timeout */
  async start(): Promise<void> {
    const first = new Promise<void>((resolve) => (this.#resolveFirst = resolve));
    this.#begin();
    const { clock, startMs } = this.#link;
    if (!(await within(clock, startMs, first))) throw this.#lastError;
  }

  close(): void {
    this.#isClosed = true;
    this.#cancelReach();
    this.#leave();
  }

  #leave(): void {
    this.#turn += 1;
    this.#cancelWatch();
    this.#cancelWatch = () => undefined;
  }

  #begin(): void {
    this.#leave();
    if (this.#isClosed || !this.#link.isConnected) return; // Or: the link tells when it is back.
    const turn = this.#turn;
    this.#watch(turn).catch((error: unknown) => {
      if (turn !== this.#turn) return;
      this.#lastError = error;
      this.#link.log.debug('a store of the cluster is not ready', { reason: reasonOf(error) });
      this.#link.clock.after(RETRY_MS, () => {
        if (turn === this.#turn) this.#begin();
      });
    });
  }

  async #watch(turn: number): Promise<void> {
    const isCurrent = (): boolean => turn === this.#turn;
    const created = await this.#bucket.ensure();
    const manager = await this.#bucket.manager();
    if (!isCurrent()) return;
    this.#listener.handleBegin(created !== this.#created);
    this.#created = created;
    const { connection, clock, log } = this.#link;
    const parts = { connection, manager, clock, log, bucket: this.#bucket.name };
    const cancel = await watchBucket(parts, {
      handleEntry: (entry) => {
        if (isCurrent()) this.#listener.handleEntry(entry);
      },
      handleComplete: () => {
        if (!isCurrent()) return;
        this.#listener.handleComplete();
        this.#resolveFirst();
      },
      handleLost: () => {
        if (isCurrent()) this.#begin();
      },
    });
    if (isCurrent()) this.#cancelWatch = cancel;
    else cancel();
  }
}
