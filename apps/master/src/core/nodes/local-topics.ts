import { TRUSTED_ACCESS } from '../access/caller.ts';
import { PublishLimitTable } from '../access/publish-limit-table.ts';
import { Traffic } from '../clients/traffic.ts';
import type { EncodedRecord, TopicListener, TopicPort, TopicSelector } from '@ubii/pm-sandbox';
import { globToRegExpSource } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import { TokenBucket, type Clock } from '@ubii/timing';
import type { LimitName } from '../limits/index.ts';
import type { Account } from '../shares/account.ts';
import { RESOURCE } from '../shares/resources.ts';
import { Publication, type PublishingClient } from '../topics/publication.ts';
import { publish, type PublishContext } from '../topics/publisher.ts';
import { REFUSALS } from '../topics/refusals.ts';
import type { RecordedSources } from '../topics/recorded-sources.ts';
import { localSubscriber } from '../topics/local-subscriber.ts';
import type { SubscriptionTable } from '../topics/subscription-table.ts';
import type { Receiver, Subscriber, TopicEntry } from '../topics/topic-entry.ts';

const NO_BYTES = new Uint8Array(0);

/** Dependencies of the topics of the master's own modules. */
export interface LocalTopicsContext extends PublishContext {
  readonly subscriptions: SubscriptionTable;
  readonly clock: Clock;
  /** Id of the master as a node: who publishes. */
  readonly nodeId: string;
  /** Pays for what modules subscribe to [AC-80]. */
  readonly account: Account;
  readonly recordedSources: RecordedSources;
  /** Id of the device that has a component with this topic. */
  readonly deviceOf: (topic: string) => string | undefined;
  /** Whether there is a session of this id. */
  readonly isSession: (id: string) => boolean;
  /** A session met a limit. */
  readonly onLimit: (limit: LimitName, sessionId: string) => void;
}

/** The topics of one session whose modules run on the master. */
interface SessionTopics {
  /** As whom its modules publish: what they make is the session's. [SE-60] */
  readonly publisher: PublishingClient;
  /** Topics that demuxers made, with the number of those that write each. */
  readonly made: Map<string, number>;
}

/**
 * The core's topics as modules on the master see them: no sockets, no copies. A topic none of them uses
 * costs nothing, because they stand in the same lists of targets as clients do.
 */
export class LocalTopics implements TopicPort {
  readonly #context: LocalTopicsContext;
  /** Publisher of all sessions; the topics of each session are its own. */
  readonly #publisher: Omit<PublishingClient, 'ownedTopics' | 'account'>;
  readonly #sessions = new Map<string, SessionTopics>();
  readonly #publication = new Publication();

  constructor(context: LocalTopicsContext) {
    this.#context = context;
    const { limits, clock, nodeId } = context;
    const nowMs = clock.monotonicMs();
    this.#publisher = {
      id: nodeId,
      publishLimits: new PublishLimitTable(limits).of(TRUSTED_ACCESS),
      recordBudget: new TokenBucket(limits.recordsPerSecond, nowMs),
      byteBudget: new TokenBucket(limits.publishedBytesPerSecond, nowMs),
      traffic: new Traffic(),
      throttle: undefined,
      publishRights: undefined, // [AC-24]
    };
  }

  subscribe(selector: TopicSelector, listener: TopicListener): Cancel {
    const { subscriptions, limits, clock, nodeId, account } = this.#context;
    const receiver = new ListeningReceiver(listener, this.#context);
    const subscriber = localSubscriber(nodeId, receiver, account, limits, clock);
    const entries = this.#select(subscriber, selector);
    for (const entry of entries) receiver.replay(entry);
    return () => subscriptions.unsubscribeAll(subscriber);
  }

  publish(
    topic: string,
    record: Uint8Array,
    valueField: number,
    sessionId: string,
  ): string | undefined {
    return this.publishAs(undefined, topic, record, valueField, sessionId);
  }

  /** [SE-61] */
  makeTopic(topic: string, sessionId: string): string | undefined {
    const { made } = this.#ofSession(sessionId) ?? {};
    if (made === undefined) return 'the session was removed';
    const writers = made.get(topic) ?? 0;
    const refusal = writers > 0 ? undefined : this.#refuseNew(sessionId, made.size);
    if (refusal === undefined) made.set(topic, writers + 1);
    return refusal;
  }

  /** [SE-62] */
  endTopics(topics: readonly string[], sessionId: string): void {
    const session = this.#sessions.get(sessionId);
    if (session === undefined) return;
    for (const topic of topics) {
      const writers = (session.made.get(topic) ?? 0) - 1;
      if (writers > 0) {
        session.made.set(topic, writers);
        continue;
      }
      session.made.delete(topic);
      const entry = this.#context.topics.get(topic);
      if (entry?.owner === session.publisher) this.#context.topics.deleteValue(entry);
    }
  }

  /** Ends what a session has, but for these topics and those that its demuxers write. [SE-62] */
  keepOnly(sessionId: string, topics: ReadonlySet<string>): void {
    const session = this.#sessions.get(sessionId);
    if (session === undefined) return;
    for (const entry of [...session.publisher.ownedTopics]) {
      if (topics.has(entry.topic) || session.made.has(entry.topic)) continue;
      this.#context.topics.deleteValue(entry);
    }
  }

  /** A session was removed: what it made ends. [SE-62] */
  endSession(sessionId: string): void {
    const session = this.#sessions.get(sessionId);
    this.#sessions.delete(sessionId);
    for (const entry of [...(session?.publisher.ownedTopics ?? [])]) {
      this.#context.topics.deleteValue(entry);
    }
  }

  /** The same for a client whose share of a lockstep pass it is; for the master without one. */
  publishAs(
    client: PublishingClient | undefined,
    topic: string,
    record: Uint8Array,
    valueField: number,
    sessionId: string,
  ): string | undefined {
    const { clock } = this.#context;
    const publisher = client ?? this.#ofSession(sessionId)?.publisher;
    if (publisher === undefined) return 'The session was removed.';
    const publication = this.#publication;
    publication.client = publisher;
    publication.topic = topic;
    publication.frame = record;
    publication.start = 0;
    publication.end = record.byteLength;
    publication.valueField = valueField;
    publication.nowMs = clock.nowMs();
    publication.monotonicMs = clock.monotonicMs();
    publication.entry = undefined;
    const isWithinRate = publisher.byteBudget.take(record.byteLength, publication.monotonicMs);
    const refusal = isWithinRate ? publish(this.#context, publication) : REFUSALS.tooManyBytes;
    // Release the frame of a record that is not retained before the next record.
    publication.frame = NO_BYTES;
    return refusal?.describe(publication, this.#context.limits);
  }

  #ofSession(sessionId: string): SessionTopics | undefined {
    const known = this.#sessions.get(sessionId);
    if (known !== undefined) return known;
    // The last outputs of an ending module must not create the topics of a removed session again.
    if (!this.#context.isSession(sessionId)) return undefined;
    const { accounts, limits } = this.#context;
    const { topicsPerSession, mappingsPerSession, retainedBytesPerClient } = limits;
    const account = accounts.createSession(sessionId, {
      [RESOURCE.topics]: topicsPerSession + mappingsPerSession,
      [RESOURCE.retainedBytes]: retainedBytesPerClient,
    });
    const publisher = { ...this.#publisher, account, ownedTopics: new Set<TopicEntry>() };
    const session = { publisher, made: new Map<string, number>() };
    this.#sessions.set(sessionId, session);
    return session;
  }

  #refuseNew(sessionId: string, made: number): string | undefined {
    const { limits, onLimit } = this.#context;
    if (made >= limits.topicsPerSession) {
      onLimit('topicsPerSession', sessionId);
      return `the demuxers of one session make at most ${limits.topicsPerSession} topics (limit topicsPerSession)`;
    }
    let all = 0;
    for (const session of this.#sessions.values()) all += session.made.size;
    if (all < limits.topicsPerClient) return undefined;
    onLimit('topicsPerClient', sessionId);
    return `the modules on the master make at most ${limits.topicsPerClient} topics (limit topicsPerClient)`;
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

/** Tells where records come from. */
type Origins = Pick<LocalTopicsContext, 'recordedSources' | 'deviceOf'>;

/** Hands records to a listener at once. */
class ListeningReceiver implements Receiver {
  readonly #listener: TopicListener;
  readonly #origins: Origins;

  constructor(listener: TopicListener, origins: Origins) {
    this.#listener = listener;
    this.#origins = origins;
  }

  deliver(entry: TopicEntry, record: Uint8Array): void {
    if (entry.valueField === 0) return this.handleGone(entry); // as on nodes [TD-42]
    this.#listener.onRecord(new LocalRecord(entry, record, this.#origins));
  }

  replay(entry: TopicEntry): void {
    if (entry.record !== undefined) this.deliver(entry, entry.record);
  }

  handleGone(entry: TopicEntry): void {
    this.#listener.onGone(entry.topic);
  }

  withdraw(): void {
    // Nothing waits: what came was handed over at once.
  }

  cancelReplay(): void {
    // There is no replay: records are delivered at once.
  }
}

/** A record of the core. Its device is looked up on request, because few modules need it. */
class LocalRecord implements EncodedRecord {
  readonly topic: string;
  readonly bytes: Uint8Array;
  readonly valueField: number;
  readonly publisherId: string;
  readonly #origins: Origins;

  constructor(entry: TopicEntry, bytes: Uint8Array, origins: Origins) {
    this.topic = entry.topic;
    this.bytes = bytes;
    this.valueField = entry.valueField;
    this.publisherId = origins.recordedSources.get(entry.topic)?.clientId ?? entry.publisherId;
    this.#origins = origins;
  }

  get deviceId(): string {
    const { recordedSources, deviceOf } = this.#origins;
    return recordedSources.get(this.topic)?.deviceId ?? deviceOf(this.topic) ?? '';
  }
}
