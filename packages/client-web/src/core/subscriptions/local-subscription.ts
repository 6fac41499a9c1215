import type { Cancel, Clock } from '@ubii/timing';
import type { DataFormat, TopicRecord } from '@ubii/proto';
import { ConnectionError } from '../connection/connection-error.ts';
import { Deferred } from '../callbacks/deferred.ts';
import type { ErrorHandler } from '../ports/error-handler.ts';
import { Listeners } from '../callbacks/listeners.ts';
import type { ReceivedRecord } from './received-record.ts';
import type { Receiver } from './receiver.ts';
import { RecordBuffer } from './record-buffer.ts';
import type { SubscribeOptions, Subscription } from './subscription.ts';
import type { ServerPattern, TopicPattern } from './topic-pattern.ts';

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

const DEFAULT_BUFFER_SIZE = 1_000;

/** One subscription of the program: filters, limits and delivers the records it is given. */
export class LocalSubscription implements Subscription, Receiver {
  readonly takesBuffers = false;
  readonly pattern: TopicPattern;
  readonly serverPattern: ServerPattern;
  /** Records of a topic per second; `Infinity` for all. */
  readonly maxRateHz: number;
  readonly #format: DataFormat | undefined;
  readonly #bufferSize: number;
  readonly #close: (subscription: LocalSubscription) => Promise<void>;
  readonly #rateLimit: RateLimit<TopicRecord> | undefined;
  readonly #ready = new Deferred<void>();
  readonly #listeners: Listeners<TopicRecord>;
  readonly #iterators = new Set<RecordBuffer<TopicRecord>>();
  /** Holds records until there is a consumer. */
  #early: RecordBuffer<TopicRecord> | undefined;
  #end: { readonly error: Error | undefined } | undefined;
  #droppedByGone = 0;

  /**
   * @param close takes the subscription out of the table
   * @throws {RangeError} if a rate or a size is not above 0
   */
  constructor(
    pattern: TopicPattern,
    serverPattern: ServerPattern,
    options: SubscribeOptions,
    { clock, onError }: { readonly clock: Clock; readonly onError: ErrorHandler },
    close: (subscription: LocalSubscription) => Promise<void>,
  ) {
    this.pattern = pattern;
    this.serverPattern = serverPattern;
    this.maxRateHz = options.maxRateHz ?? Infinity;
    this.#format = options.format;
    this.#bufferSize = options.bufferSize ?? DEFAULT_BUFFER_SIZE;
    if (!(this.#bufferSize >= 1)) {
      throw new RangeError(`Expected a buffer size of 1 or more, received ${this.#bufferSize}`);
    }
    this.#listeners = new Listeners(onError);
    this.#close = close;
    this.#rateLimit =
      options.maxRateHz === undefined
        ? undefined
        : new RateLimit(clock, options.maxRateHz, (record) => this.#deliver(record));
    this.#early = new RecordBuffer(this.#bufferSize, () => undefined);
  }

  get ready(): Promise<void> {
    return this.#ready.promise;
  }

  get dropped(): number {
    let dropped = this.#droppedByGone + (this.#early?.dropped ?? 0);
    for (const iterator of this.#iterators) dropped += iterator.dropped;
    return dropped;
  }

  onRecord(fn: (record: TopicRecord) => void): this {
    if (this.#end === undefined) this.#listeners.add(fn);
    this.#scheduleEarly();
    return this;
  }

  [Symbol.asyncIterator](): AsyncIterator<TopicRecord, undefined> {
    const iterator = new RecordBuffer<TopicRecord>(this.#bufferSize, () => {
      if (this.#iterators.delete(iterator)) this.#droppedByGone += iterator.dropped;
    });
    this.#iterators.add(iterator);
    if (this.#end === undefined) {
      this.#scheduleEarly();
    } else {
      this.#flushEarly();
      iterator.end(this.#end.error);
    }
    return iterator;
  }

  async close(): Promise<void> {
    this.end(undefined);
    await this.#close(this);
  }

  handleRecord(received: ReceivedRecord): void {
    if (this.#end !== undefined) return;
    const record = received.decoded;
    if (this.#format !== undefined && record.format !== this.#format) return;
    if (this.#rateLimit === undefined) this.#deliver(record);
    else this.#rateLimit.handle(record);
  }

  /** A record without a value says nothing that a subscription could deliver. [TD-13] */
  handleGone(): void {}

  /** The master has accepted it. */
  handleAccepted(): void {
    this.#ready.resolve();
  }

  /** Ends callbacks and iterators, the latter with the error if there is one. */
  end(error: Error | undefined): void {
    if (this.#end !== undefined) return;
    this.#end = { error };
    this.#ready.reject(error ?? new ConnectionError('closed', 'The subscription was closed'));
    this.#rateLimit?.close();
    if (this.#listeners.size > 0 || this.#iterators.size > 0) this.#flushEarly();
    this.#listeners.clear();
    for (const iterator of this.#iterators) iterator.end(error);
  }

  /** Ends the iterators with an error; callbacks stand. */
  failIterators(error: Error): void {
    for (const iterator of this.#iterators) {
      iterator.end(error);
      this.#droppedByGone += iterator.dropped;
    }
    this.#iterators.clear();
  }

  #deliver(record: TopicRecord): void {
    if (this.#early === undefined) this.#emit(record);
    else this.#early.push(record);
  }

  #emit(record: TopicRecord): void {
    this.#listeners.emit(record);
    for (const iterator of this.#iterators) iterator.push(record);
  }

  /** Not at once: a callback that ran inside `onRecord` would surprise its owner. */
  #scheduleEarly(): void {
    if (this.#early !== undefined) void Promise.resolve().then(() => this.#flushEarly());
  }

  #flushEarly(): void {
    const early = this.#early;
    if (early === undefined) return;
    this.#early = undefined;
    this.#droppedByGone += early.dropped;
    for (const record of early.drain()) this.#emit(record);
  }
}
