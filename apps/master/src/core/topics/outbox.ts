import { encodeRecord } from '@ubii/proto';
import type { Clock, EndOfTurn, TurnTask } from '@ubii/timing';
import type { Limits } from '../limits/index.ts';
import type { ClientConnection } from '../ports/client-connection.ts';
import type { Account } from '../shares/account.ts';
import { Streak } from '../counters/streak.ts';
import type { BatchNode } from './batch-node.ts';
import { isEventField, type TopicEntry } from './topic-entry.ts';
import type { TurnBatches } from './turn-batches.ts';
import { WaitingRecords } from './waiting-records.ts';

/** Records of this size are large [TD-35], bytes. */
const LARGE_RECORD_BYTES = 16 * 1024;

/** What an outbox needs of a connection. */
export type BatchSink = Pick<ClientConnection, 'send' | 'queuedBytes'>;

/** Dependencies of an outbox. */
export interface OutboxContext {
  readonly clock: Clock;
  readonly endOfTurn: EndOfTurn;
  readonly batches: TurnBatches;
  readonly limits: Limits;
  /** Records were handed to the connection. */
  readonly onSent: (records: number, bytes: number) => void;
  /** A record of this topic was dropped. */
  readonly onDropped: (entry: TopicEntry) => void;
}

/** Everything on its way to one client: what leaves at the end of this turn, and what waits for its socket. */
export class Outbox implements TurnTask {
  readonly #context: OutboxContext;
  // Members used for every record come first, next to each other: with many subscribers, each further cache line is an
  // access to slower memory.
  #connection: BatchSink | undefined = undefined;
  #batch: BatchNode | undefined = undefined;
  #isTouched = false;
  #handedBytes = 0;
  #handedRecords = 0;
  /** Undefined while nothing waits, which is nearly always. */
  #waiting: WaitingRecords | undefined = undefined;
  /** Undefined while nothing is to be replayed. */
  #replays: Set<TopicEntry> | undefined = undefined;
  readonly #account: Account;
  #openedSequence = 0;
  /** It gets deletions of values, which only nodes understand [TD-42]. */
  sendsDeletions = false;
  /** Records that were dropped because the client was too slow [TD-34]. */
  readonly drops = new Streak();

  /** @param account Pays for what waits. */
  constructor(context: OutboxContext, account: Account) {
    this.#context = context;
    this.#account = account;
  }

  get isOpen(): boolean {
    return this.#connection !== undefined;
  }

  /** Records that wait because the socket cannot take more. */
  get waitingCount(): number {
    return this.#waiting?.count ?? 0;
  }

  /** Bytes queued for the socket. */
  get waitingBytes(): number {
    return this.#waiting?.byteLength ?? 0;
  }

  /** Records handed to connections so far. */
  get handedRecords(): number {
    return this.#handedRecords;
  }

  /** Bytes of records handed to connections so far. */
  get handedBytes(): number {
    return this.#handedBytes;
  }

  /**
   * Sends to this connection from now on: first what is to be replayed, then what waited for the connection before
   * [TD-7] [TD-24].
   * @param sequence Sequence number of the newest record of all.
   */
  open(connection: BatchSink, sequence: number): void {
    this.#moveBatchToWaiting();
    this.#connection = connection;
    this.#openedSequence = sequence;
    for (const entry of this.#replays ?? []) {
      if (entry.record !== undefined && !this.#waiting?.has(entry)) this.#deliverRetained(entry);
    }
    this.#replays = undefined;
    this.handleDrain();
  }

  /** There is no connection any more. What was on its way is replayed as a retained record [TD-33]. */
  close(): void {
    this.#connection = undefined;
    for (const node of this.#batch?.nodes() ?? []) this.queueReplay(node.entry!);
    for (const entry of this.#waiting?.topics() ?? []) this.queueReplay(entry);
    this.#batch = undefined;
    this.#waiting?.clear();
    this.#waiting = undefined;
  }

  /** Everything on its way is void: the client is gone. */
  discard(): void {
    this.close();
    this.#replays = undefined;
  }

  /** Gives the client one record. The hot path: runs once for each record and subscriber. */
  deliver(entry: TopicEntry, record: Uint8Array, isEvent: boolean): void {
    if (this.#connection === undefined) return; // [TD-33]
    if (!this.#isTouched) {
      this.#isTouched = true;
      this.#context.endOfTurn.add(this);
    }
    const batch = (this.#batch ?? this.#context.batches.empty).append(entry, record, isEvent);
    this.#batch = batch;
    if (batch.byteLength >= this.#context.limits.batchBytes) this.#send();
  }

  /**
   * Gives the client the retained record of a topic it subscribed to when the newest record of all had
   * the number `sinceSequence`, unless it has got a newer one by itself. Without a connection it is queued
   * to the next [TD-24].
   */
  replay(entry: TopicEntry, sinceSequence: number): void {
    if (entry.record === undefined) return;
    if (this.#connection === undefined) this.queueReplay(entry);
    else if (entry.sequence <= Math.max(sinceSequence, this.#openedSequence)) {
      this.#deliverRetained(entry);
    }
  }

  /** Queues the retained record of a topic, as soon as it has a connection. */
  queueReplay(entry: TopicEntry): void {
    this.#replays ??= new Set();
    this.#replays.add(entry);
  }

  handleGone(entry: TopicEntry): void {
    if (this.sendsDeletions) this.deliver(entry, encodeRecord({ topic: entry.topic }), false);
  }

  /** Removes an expired value from the queue of the socket. [TD-47] */
  withdraw(entry: TopicEntry): void {
    const waiting = this.#waiting;
    waiting?.drop(entry);
    if (waiting?.count === 0) this.#waiting = undefined;
  }

  /** The topic is forgotten or the client has no subscription to it any more. */
  cancelReplay(entry: TopicEntry): void {
    this.#replays?.delete(entry);
  }

  handleEndOfTurn(): void {
    this.#isTouched = false;
    this.#send();
  }

  /** The connection can take more: what waits leaves, in pieces, as far as it goes. */
  handleDrain(): void {
    while (this.#waiting !== undefined && this.#canSend(this.#waiting)) {
      let batch = this.#context.batches.empty;
      while (batch.byteLength < this.#context.limits.batchBytes) {
        const taken = this.#waiting.take();
        if (taken === undefined) break;
        batch = batch.append(taken.entry, taken.record, taken.isEvent, taken.stamp);
      }
      if (this.#waiting.count === 0) this.#waiting = undefined;
      this.#hand(batch);
    }
  }

  #send(): void {
    const batch = this.#batch;
    if (batch === undefined) return;
    if (this.#waiting === undefined && this.#canSend(batch)) {
      this.#batch = undefined;
      this.#hand(batch);
    } else {
      this.#moveBatchToWaiting();
      this.handleDrain();
    }
  }

  #moveBatchToWaiting(): void {
    const nodes = this.#batch?.nodes() ?? [];
    this.#batch = undefined;
    if (nodes.length === 0) return;
    this.#waiting ??= this.#createWaiting();
    for (const { entry, record, isEvent, stamp } of nodes) {
      this.#waiting.push(entry!, record!, isEvent, stamp); // [TD-31]
    }
  }

  #createWaiting(): WaitingRecords {
    const { clock, limits, onDropped } = this.#context;
    return new WaitingRecords({
      account: this.#account,
      maxEventsPerTopic: limits.queuedEventsPerTopic,
      onDropped: (entry) => {
        this.drops.add(clock.monotonicMs());
        onDropped(entry);
      },
    });
  }

  #deliverRetained(entry: TopicEntry): void {
    this.deliver(entry, entry.record!, isEventField(entry.valueField));
  }

  /** Of large records fewer lie in the socket, where no newer one can take their place [TD-35]. */
  #canSend({
    byteLength,
    count,
  }: {
    readonly byteLength: number;
    readonly count: number;
  }): boolean {
    const { connectionQueuedBytes, connectionQueuedLargeBytes } = this.#context.limits;
    const isLarge = byteLength >= LARGE_RECORD_BYTES * count;
    const maxBytes = isLarge ? connectionQueuedLargeBytes : connectionQueuedBytes;
    return this.#connection !== undefined && this.#connection.queuedBytes <= maxBytes;
  }

  #hand(batch: BatchNode): void {
    this.#connection?.send(batch);
    this.#handedBytes += batch.byteLength;
    this.#handedRecords += batch.count;
    this.#context.onSent(batch.count, batch.byteLength);
  }
}
