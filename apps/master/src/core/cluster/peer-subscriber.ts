import { ServiceError, type ClusterInterest, type ClusterRecords } from '@ubii/proto';
import { prepareRecordsForMasters, type RecordsForMasters } from '@ubii/proto/wire';
import type { Cancel, Clock, EndOfTurn, TurnTask } from '@ubii/timing';
import type { Counters } from '../counters/counters.ts';
import type { BatchEncoder, RecordBatch } from '../ports/record-batch.ts';
import type { Log } from '../ports/log.ts';
import type { Accounts } from '../shares/accounts.ts';
import { isSharedTopic } from '../topics/topic-names.ts';
import type { BatchNode } from '../topics/batch-node.ts';
import type { BatchSink } from '../topics/outbox.ts';
import type { ReadRights } from '../topics/rights.ts';
import type { ClientSubscriber } from '../topics/subscriber.ts';
import type { SubscriberFactory } from '../topics/subscriber-factory.ts';
import type { SubscriptionTable } from '../topics/subscription-table.ts';
import type { Receiver, TopicEntry } from '../topics/topic-entry.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import { describeRecords } from './describe-records.ts';
import type { ProvenBus } from './proven-bus.ts';
import type { OutgoingStream } from './streams.ts';

/** Time until what waits for the bus is tried again, milliseconds. */
const DRAIN_MS = 5;
/** Bytes of values in one message. */
const VALUES_BYTES = 256 * 1024;
/** Id under which the subscriptions of another master to everything stand. */
const EVERYTHING = 'everything';

/** Dependencies of what another master gets. */
export interface PeerSubscriberContext {
  readonly clock: Clock;
  readonly log: Log;
  readonly bus: ProvenBus;
  readonly endOfTurn: EndOfTurn;
  readonly counters: Counters;
  readonly accounts: Accounts;
  readonly topics: TopicTable;
  readonly subscriptions: SubscriptionTable;
  readonly createSubscriber: SubscriberFactory;
}

/**
 * Another master as a subscriber: it gets the records for its own subscribers as any client does, with the same
 * queue in front of the bus. [CU-10]
 */
export class PeerSubscriber implements Receiver, BatchSink, TurnTask {
  readonly #context: PeerSubscriberContext;
  readonly #stream: OutgoingStream;
  readonly #subscriber: ClientSubscriber;
  /** The same, with this as its receiver. */
  readonly #received: Omit<ClientSubscriber, 'outbox'> & { readonly outbox: Receiver };
  readonly #values = new Set<TopicEntry>();
  #isTouched = false;
  #cancelDrain: Cancel | undefined = undefined;

  constructor(context: PeerSubscriberContext, peerId: string, stream: OutgoingStream) {
    this.#context = context;
    this.#stream = stream;
    const account = context.accounts.createForeign(peerId);
    this.#subscriber = context.createSubscriber(peerId, true, account, true);
    this.#received = { ...this.#subscriber, outbox: this, readRights: OTHERS_TOPICS };
    this.#subscriber.outbox.sendsDeletions = true; // [CU-14]
    this.#subscriber.outbox.open(this, context.topics.sequence);
  }

  /** Records sent so far. */
  get sentRecords(): number {
    return this.#subscriber.outbox.handedRecords;
  }

  /** Records that wait to be sent. */
  get queuedRecords(): number {
    return this.#subscriber.outbox.waitingCount;
  }

  /** Records that were dropped because they could not be sent as fast as they were published. */
  get dropped(): number {
    return this.#subscriber.outbox.drops.count;
  }

  /** Adds an interest, and sends the current values. */
  want(interest: ClusterInterest): void {
    try {
      for (const entry of this.#subscribe(interest)) this.replay(entry);
    } catch (error) {
      const { message } = ServiceError.from(error);
      this.#context.log.warn('a subscription of another master failed', { reason: message });
    }
  }

  /** Removes an interest. */
  endWant({ topic, pattern, profile, everything }: ClusterInterest): void {
    const { subscriptions } = this.#context;
    const subscriber = this.#received;
    if (everything) subscriptions.unwatch(subscriber, EVERYTHING);
    else if (profile !== undefined) subscriptions.unsubscribeComponents(subscriber, profile);
    else if (pattern !== '') subscriptions.unsubscribePattern(subscriber, pattern);
    else subscriptions.unsubscribeTopic(subscriber, topic);
  }

  /** The other master receives again: sends all values that it has an interest in. */
  replayAll(): void {
    for (const entry of this.#context.topics.values()) {
      if (entry.originId !== undefined) continue;
      if (this.#context.subscriptions.isSubscribed(this.#received, entry)) this.replay(entry);
    }
  }

  /** Sends what waits, if the bus takes it. */
  sweep(): void {
    this.#subscriber.outbox.handleDrain();
  }

  close(): void {
    this.#cancelDrain?.();
    this.#values.clear();
    this.#context.subscriptions.unsubscribeAll(this.#received);
    this.#subscriber.outbox.discard();
    this.#subscriber.sampler.discard();
  }

  // --- What the topics give it ---

  deliver(entry: TopicEntry, record: Uint8Array, isEvent: boolean): void {
    this.#touch();
    this.#subscriber.outbox.deliver(entry, record, isEvent);
  }

  replay(entry: TopicEntry): void {
    this.#touch();
    this.#values.add(entry);
  }

  handleGone(entry: TopicEntry): void {
    this.#touch();
    this.#subscriber.outbox.handleGone(entry);
  }

  withdraw(entry: TopicEntry): void {
    this.#subscriber.outbox.withdraw(entry);
  }

  cancelReplay(entry: TopicEntry): void {
    this.#values.delete(entry);
  }

  // --- What its queue gives to the bus ---

  get queuedBytes(): number {
    return this.#context.bus.queuedBytes;
  }

  send(batch: RecordBatch): void {
    this.#context.counters.recordsToMasters += batch.count;
    this.#stream.sendRecords(batch.memo(PREPARED));
  }

  handleEndOfTurn(): void {
    this.#isTouched = false;
    const { outbox } = this.#subscriber;
    // What was published comes before the values that stand after it.
    outbox.handleEndOfTurn();
    this.#sendValues();
    if (outbox.waitingCount > 0) this.#drainLater();
  }

  #subscribe({ topic, pattern, profile, everything, maxRateHz }: ClusterInterest): TopicEntry[] {
    const { subscriptions } = this.#context;
    const subscriber = this.#received;
    if (everything) return subscriptions.watch(subscriber, EVERYTHING);
    if (profile !== undefined) {
      return subscriptions.subscribeComponents(subscriber, profile, maxRateHz);
    }
    if (pattern !== '') return subscriptions.subscribePattern(subscriber, pattern, maxRateHz);
    return subscriptions.subscribeTopic(subscriber, topic, maxRateHz);
  }

  #touch(): void {
    if (this.#isTouched) return;
    this.#isTouched = true;
    this.#context.endOfTurn.add(this);
  }

  #sendValues(): void {
    let entries: TopicEntry[] = [];
    let byteLength = 0;
    const flush = (): void => {
      if (entries.length > 0) this.#stream.send({ values: valuesOf(entries) });
      entries = [];
      byteLength = 0;
    };
    for (const entry of this.#values) {
      if (entry.record === undefined || entry.originId !== undefined) continue;
      entries.push(entry);
      byteLength += entry.record.byteLength;
      if (byteLength >= VALUES_BYTES) flush();
    }
    this.#values.clear();
    flush();
  }

  #drainLater(): void {
    this.#cancelDrain ??= this.#context.clock.after(DRAIN_MS, () => {
      this.#cancelDrain = undefined;
      this.#subscriber.outbox.handleDrain();
      if (this.#subscriber.outbox.waitingCount > 0) this.#drainLater();
    });
  }
}

/** [CU-16] */
const OTHERS_TOPICS: ReadRights = { mayRead: isSharedTopic };

/** The records of a batch, prepared once for all masters that get them. */
const PREPARED: BatchEncoder<RecordsForMasters> = {
  encode(batch) {
    // All batches of outboxes are chains of nodes.
    const nodes = (batch as BatchNode).nodes();
    return prepareRecordsForMasters(
      describeRecords(nodes as (BatchNode & { record: Uint8Array })[]),
    );
  },
};

function valuesOf(entries: readonly TopicEntry[]): ClusterRecords {
  return describeRecords(entries as (TopicEntry & { record: Uint8Array })[]);
}
