import { Traffic } from '../clients/traffic.ts';
import type {
  Cancel,
  EncodedRecord,
  TopicListener,
  TopicPort,
  TopicSelector,
} from '@ubii/pm-sandbox';
import { globToRegExpSource } from '@ubii/proto';
import type { Limits } from '../limits.ts';
import type { Clock } from '../ports/clock.ts';
import { Publication, type PublishingClient } from '../topics/publication.ts';
import { publish, type PublishContext } from '../topics/publisher.ts';
import type { Receiver } from '../topics/receiver.ts';
import type { Subscriber } from '../topics/subscriber.ts';
import { TokenBucket } from '../topics/token-bucket.ts';
import type { TopicEntry } from '../topics/topic-entry.ts';

const NO_BYTES = new Uint8Array(0);

/** What the topics of the master's own modules work on. */
export interface LocalTopicsContext extends PublishContext {
  readonly clock: Clock;
  /** Id of the master as a node: who publishes. */
  readonly nodeId: string;
  /** Id of the device that has a component with this topic. */
  readonly deviceOf: (topic: string) => string | undefined;
}

/**
 * The core's topics as modules on the master see them: no sockets, no copies. A topic none of them uses
 * costs nothing, because they stand in the same lists of targets as clients do.
 */
export class LocalTopics implements TopicPort {
  readonly #context: LocalTopicsContext;
  readonly #publisher: PublishingClient;
  readonly #publication = new Publication();

  constructor(context: LocalTopicsContext) {
    this.#context = context;
    const { limits, clock, nodeId } = context;
    const nowMs = clock.monotonicMs();
    this.#publisher = {
      id: nodeId,
      ownedTopics: new Set(),
      recordBudget: new TokenBucket(limits.recordsPerSecond, nowMs),
      byteBudget: new TokenBucket(limits.publishedBytesPerSecond, nowMs),
      traffic: new Traffic(),
      throttle: undefined,
      publishRights: undefined, // [AC-24]
    };
  }

  subscribe(selector: TopicSelector, listener: TopicListener): Cancel {
    const { subscriptions, limits, clock, nodeId, deviceOf } = this.#context;
    const receiver = new ListeningReceiver(listener, deviceOf);
    const subscriber = localSubscriber(nodeId, receiver, limits, clock);
    const entries = this.#select(subscriber, selector);
    for (const entry of entries) receiver.replay(entry);
    return () => subscriptions.unsubscribeAll(subscriber);
  }

  publish(topic: string, record: Uint8Array, valueField: number): string | undefined {
    return this.publishAs(undefined, topic, record, valueField);
  }

  /** The same for a client whose share of a lockstep pass it is; for the master without one. */
  publishAs(
    client: PublishingClient | undefined,
    topic: string,
    record: Uint8Array,
    valueField: number,
  ): string | undefined {
    const { clock } = this.#context;
    const publication = this.#publication;
    publication.client = client ?? this.#publisher;
    publication.topic = topic;
    publication.frame = record;
    publication.start = 0;
    publication.end = record.byteLength;
    publication.valueField = valueField;
    publication.nowMs = clock.nowMs();
    publication.monotonicMs = clock.monotonicMs();
    publication.entry = undefined;
    const refusal = publish(this.#context, publication);
    // What is not kept need not stay in memory until the next record.
    publication.frame = NO_BYTES;
    return refusal?.describe(publication, this.#context.limits);
  }

  #select(subscriber: Subscriber, selector: TopicSelector): readonly TopicEntry[] {
    const { subscriptions } = this.#context;
    switch (selector.kind) {
      case 'topic':
        return subscriptions.subscribeTopic(subscriber, selector.topic, 0);
      case 'regex':
        return subscriptions.subscribePattern(subscriber, selector.source, 0);
      case 'glob':
        return subscriptions.subscribePattern(subscriber, globToRegExpSource(selector.glob), 0);
      case 'component':
        return subscriptions.subscribeComponents(subscriber, selector.profile, 0);
    }
  }
}

/** The value of a topic was deleted: modules that use it are told, here and on nodes [TD-42]. */
export function tellOfGone({ subscriptions }: PublishContext, entry: TopicEntry): void {
  for (const receiver of subscriptions.targetsOf(entry).direct) receiver.handleGone(entry);
}

/** Hands records to a listener at once. */
class ListeningReceiver implements Receiver {
  readonly #listener: TopicListener;
  readonly #deviceOf: (topic: string) => string | undefined;

  constructor(listener: TopicListener, deviceOf: (topic: string) => string | undefined) {
    this.#listener = listener;
    this.#deviceOf = deviceOf;
  }

  deliver(entry: TopicEntry, record: Uint8Array): void {
    this.#listener.onRecord(new LocalRecord(entry, record, this.#deviceOf));
  }

  replay(entry: TopicEntry): void {
    if (entry.record !== undefined) this.deliver(entry, entry.record);
  }

  handleGone(entry: TopicEntry): void {
    this.#listener.onGone(entry.topic);
  }

  forgive(): void {
    // Nothing is owed: what came was handed over at once.
  }
}

/** A record of the core. Its device is looked for only when somebody asks, which few do. */
class LocalRecord implements EncodedRecord {
  readonly topic: string;
  readonly bytes: Uint8Array;
  readonly valueField: number;
  readonly publisherId: string;
  readonly #deviceOf: (topic: string) => string | undefined;

  constructor(
    entry: TopicEntry,
    bytes: Uint8Array,
    deviceOf: (topic: string) => string | undefined,
  ) {
    this.topic = entry.topic;
    this.bytes = bytes;
    this.valueField = entry.valueField;
    this.publisherId = entry.publisherId;
    this.#deviceOf = deviceOf;
  }

  get deviceId(): string {
    return this.#deviceOf(this.topic) ?? '';
  }
}

function localSubscriber(
  clientId: string,
  outbox: Receiver,
  limits: Limits,
  clock: Clock,
): Subscriber {
  const { patternMatchMs, patternMatchMsPerSecond } = limits;
  return {
    clientId,
    isExtension: true,
    outbox,
    readRights: undefined,
    sampler: undefined,
    patternBudget: new TokenBucket(patternMatchMsPerSecond, clock.monotonicMs(), patternMatchMs),
    topics: new Set(),
    patterns: new Set(),
    selections: new Set(),
    watchers: new Set(),
  };
}
