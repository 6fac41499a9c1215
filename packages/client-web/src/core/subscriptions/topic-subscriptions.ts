import type { PatternSource } from '@ubii/patterns';
import { INFO_TOPICS, ServiceError, isMasterTopic } from '@ubii/proto';
import type { Component, DataFormat, EmptyRecord, Init, TopicSubscription } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { ComponentProfile } from './component-profile.ts';
import { ComponentTopics } from './component-topics.ts';
import type { EncodedListener } from './encoded-record.ts';
import { EncodedSubscription } from './encoded-subscription.ts';
import type { ErrorHandler } from '../ports/error-handler.ts';
import { LocalSubscription } from './local-subscription.ts';
import { ReceivedRecord } from './received-record.ts';
import type { Receiver } from './receiver.ts';
import { SubscriptionSync } from './subscription-sync.ts';
import type { SubscribeOptions, Subscription } from './subscription.ts';
import { MAX_REMEMBERED_TOPICS, toServerPattern } from './topic-pattern.ts';
import type { ServerPattern, TopicMatch, TopicPattern } from './topic-pattern.ts';

/** Dependencies and callbacks of the subscriptions. */
export interface TopicSubscriptionsOptions {
  readonly clock: Clock;
  /** Matches regular expressions. */
  readonly patterns: PatternSource;
  readonly callTopicSubscription: (request: Init<TopicSubscription>) => Promise<unknown>;
  /** Topics that have a value. */
  readonly listTopics: () => Promise<readonly string[]>;
  readonly listComponents: (profiles: readonly ComponentProfile[]) => Promise<readonly Component[]>;
  /** The master refused a subscription, which has ended with this error, or does not list components. */
  readonly handleProblem: (error: ServiceError) => void;
  readonly handleUnknownClient: (error: ServiceError) => void;
  /** A callback of the program failed. */
  readonly onError: ErrorHandler;
}

/** Receivers of the records of a topic. */
interface Route {
  readonly receivers: readonly Receiver[];
  /** Subscriptions at the master that match the topic, profiles left out. */
  readonly countAtMaster: number;
}

interface Group {
  readonly pattern: ServerPattern;
  readonly members: Set<Receiver>;
  /** Undefined: not by its topic, or the code that matches is being loaded; the master is asked then. */
  match: TopicMatch | undefined;
  isLoading: boolean;
}

/**
 * All subscriptions of the program. Those with the same pattern are one subscription at the master,
 * from the first to the last. The receivers of a topic are computed once, not per record.
 */
export class TopicSubscriptions {
  readonly #options: TopicSubscriptionsOptions;
  readonly #groups = new Map<string, Group>();
  readonly #sync: SubscriptionSync;
  readonly #componentTopics: ComponentTopics;
  readonly #routes = new Map<string, Route>();
  /**
   * The newest record of each received topic. The master sends its own only with the first
   * subscription of a pattern; a second one in this program gets it from here.
   */
  readonly #newest = new Map<string, ReceivedRecord>();
  /** Topics whose newest record is not kept, because its buffer was transferred to a subscriber. */
  readonly #transferredTopics = new Set<string>();
  #encodedCount = 0;
  /** Topics with a value when the connection was lost, and without a record since. */
  #unconfirmed = new Set<string>();
  /** Subscriptions to devices, while component profiles exist. */
  #deviceNews: readonly Subscription<'device'>[] = [];
  /** Subscriptions by topic that replace profiles on masters that do not support them. */
  readonly #substitutes = new Map<string, Subscription>();
  #takesComponents = true;

  constructor(options: TopicSubscriptionsOptions) {
    this.#options = options;
    this.#sync = new SubscriptionSync({
      clock: options.clock,
      call: options.callTopicSubscription,
      handleAccepted: (key) => this.#handleAccepted(key),
      handleRefused: (key, error) => this.#handleRefused(key, error),
      handleUnknownClient: options.handleUnknownClient,
    });
    this.#componentTopics = new ComponentTopics({
      listComponents: options.listComponents,
      handleChange: () => this.#handleComponentTopics(),
      handleRecord: (record) => this.#handleLateRecord(record),
    });
  }

  /**
   * @throws {TypeError} if the pattern is empty or not a regular expression
   * @throws {RangeError} if a rate or a size is not above 0
   */
  subscribe<F extends DataFormat>(
    pattern: TopicPattern,
    options: SubscribeOptions<F>,
  ): Subscription<F> {
    const subscription: LocalSubscription = new LocalSubscription(
      pattern,
      toServerPattern(pattern, this.#options.patterns),
      options,
      this.#options,
      () => this.#remove(subscription),
    );
    this.#add(subscription);
    // It lets no other format pass.
    return subscription as unknown as Subscription<F>;
  }

  /**
   * Subscribes to encoded records. They are decoded only if another subscription needs the values.
   * @returns ends it
   * @throws {TypeError} if the pattern is empty or not a regular expression
   */
  subscribeEncoded(pattern: TopicPattern, listener: EncodedListener): () => void {
    const subscription = new EncodedSubscription(
      toServerPattern(pattern, this.#options.patterns),
      listener,
      this.#options.onError,
    );
    this.#encodedCount += 1;
    this.#add(subscription);
    return () => {
      subscription.end();
      void this.#remove(subscription);
    };
  }

  /** True when there are subscriptions to encoded records. */
  get hasEncoded(): boolean {
    return this.#encodedCount > 0;
  }

  /** Hands a record to everyone who subscribed to it, to each once. */
  handleRecord(record: ReceivedRecord): void {
    const { topic } = record;
    this.#unconfirmed.delete(topic);
    const { receivers } = this.#routeOf(topic);
    if (!record.hasValue) {
      this.#forget(topic);
      for (const receiver of receivers) receiver.handleGone(topic);
      return;
    }
    const isUnknown = this.#componentTopics.isUnknown(topic);
    const isHandedOver =
      record.isTransferable && !isUnknown && receivers.length === 1 && receivers[0]!.takesBuffers;
    for (const receiver of receivers) receiver.handleRecord(record, isHandedOver);
    if (isHandedOver) {
      this.#newest.delete(topic);
      if (this.#transferredTopics.size < MAX_REMEMBERED_TOPICS) this.#transferredTopics.add(topic);
    } else if (receivers.length > 0) this.#remember(record);
    if (isUnknown) this.#componentTopics.hold(record);
  }

  /** Number of subscriptions on the master that match a topic, without profiles. */
  countAtMaster(topic: string): number {
    return this.#routeOf(topic).countAtMaster;
  }

  /**
   * The link is up: makes the master have all subscriptions.
   * @throws {ConnectionError | ServiceError} if that failed
   */
  async resume(link: { clientId: string; takesComponents: boolean }): Promise<void> {
    this.#takesComponents = link.takesComponents;
    await this.#sync.resume(link);
    try {
      await this.#componentTopics.refresh();
    } catch (error) {
      if (!(error instanceof ServiceError)) throw error;
      this.#options.handleProblem(error);
    }
    await this.#endDoubtful();
  }

  /** The link is gone. */
  pause(): void {
    this.#sync.pause();
    if (!this.hasEncoded) return;
    for (const topic of [...this.#newest.keys(), ...this.#transferredTopics]) {
      if (!isMasterTopic(topic)) this.#unconfirmed.add(topic);
    }
  }

  /** Handles values that were deleted while there was no link, which the master does not report. [TD-42] */
  async #endDoubtful(): Promise<void> {
    if (this.#unconfirmed.size === 0) return;
    let existing: ReadonlySet<string>;
    try {
      existing = new Set(await this.#options.listTopics());
    } catch (error) {
      if (!(error instanceof ServiceError)) throw error;
      return; // asked again after the next reconnect
    }
    for (const topic of [...this.#unconfirmed]) {
      if (existing.has(topic)) continue;
      this.handleRecord(ReceivedRecord.fromDecoded(emptyRecord(topic)));
    }
    this.#unconfirmed.clear();
  }

  /** Ends everything. */
  closeAll(): void {
    const groups = [...this.#groups.values()];
    this.#groups.clear();
    this.#routes.clear();
    this.#newest.clear();
    this.#transferredTopics.clear();
    this.#unconfirmed.clear();
    this.#encodedCount = 0;
    this.#substitutes.clear();
    this.#deviceNews = [];
    this.#componentTopics.clear();
    this.#sync.clear();
    for (const { members } of groups) for (const member of members) member.end(undefined);
  }

  /** The client stopped permanently: loops end with the error. Callbacks stand, should it connect again. */
  failIterators(error: Error): void {
    for (const { members } of this.#groups.values()) {
      for (const member of members) member.failIterators(error);
    }
  }

  #add(subscription: Receiver): void {
    const { serverPattern: pattern } = subscription;
    let group = this.#groups.get(pattern.key);
    const isFirst = group === undefined;
    group ??= { pattern, members: new Set(), match: matchAtHand(pattern), isLoading: false };
    group.members.add(subscription);
    this.#groups.set(pattern.key, group);
    this.#routes.clear();
    if (isFirst && pattern.kind === 'component') this.#addProfile(pattern.key, pattern.profile);
    if (isFirst && pattern.kind === 'regex' && group.match === undefined) void this.#load(group);
    if (group.isLoading) return;
    this.#sync.want(pattern, rateOf(group));
    if (isFirst) return;
    // With another rate the master has yet to accept it, and will not send its retained records again.
    if (this.#sync.isAccepted(pattern.key)) subscription.handleAccepted();
    if (!this.#sync.isHeld(pattern.key)) return;
    for (const record of this.#newest.values()) {
      if (this.#selects(group, record.topic)) subscription.handleRecord(record, false);
    }
    for (const topic of this.#transferredTopics) {
      if (!this.#selects(group, topic)) continue;
      this.#sync.renew(pattern.key);
      return;
    }
  }

  /** The master is asked once records can be distinguished; its retained ones come with that. [TD-64] */
  async #load(group: Group): Promise<void> {
    const { pattern } = group;
    if (pattern.kind !== 'regex' || pattern.matcher.match !== undefined) return;
    group.isLoading = true;
    const isWanted = (): boolean => this.#groups.get(pattern.key) === group;
    try {
      group.match = await pattern.matcher.load();
    } catch (cause) {
      if (isWanted()) this.#handleRefused(pattern.key, notLoaded(pattern.source, cause));
      return;
    }
    group.isLoading = false;
    if (!isWanted()) return;
    this.#routes.clear();
    this.#sync.want(pattern, rateOf(group));
  }

  async #remove(subscription: Receiver): Promise<void> {
    const { serverPattern: pattern } = subscription;
    const group = this.#groups.get(pattern.key);
    if (group === undefined || !group.members.delete(subscription)) return;
    if (subscription.takesBuffers) this.#encodedCount -= 1;
    this.#routes.clear();
    if (group.members.size > 0) {
      if (!group.isLoading) this.#sync.want(pattern, rateOf(group));
      return;
    }
    this.#groups.delete(pattern.key);
    if (pattern.kind === 'component') this.#removeProfile(pattern.key);
    // Remove values of topics that are not received any more.
    for (const topic of this.#newest.keys()) {
      if (this.#routeOf(topic).receivers.length === 0) this.#newest.delete(topic);
    }
    for (const topic of this.#transferredTopics) {
      if (this.#routeOf(topic).receivers.length === 0) this.#transferredTopics.delete(topic);
    }
    await this.#sync.unwant(pattern.key);
  }

  #handleAccepted(key: string): void {
    const group = this.#groups.get(key);
    if (group === undefined) return;
    for (const member of group.members) member.handleAccepted();
    if (group.pattern.kind === 'component')
      void this.#componentTopics.refresh().catch(() => undefined);
  }

  #handleRefused(key: string, error: ServiceError): void {
    const group = this.#groups.get(key);
    if (group === undefined) return;
    this.#groups.delete(key);
    this.#routes.clear();
    if (group.pattern.kind === 'component') this.#removeProfile(key);
    for (const member of group.members) {
      if (member.takesBuffers) this.#encodedCount -= 1;
      member.end(error);
    }
    this.#options.handleProblem(error);
  }

  /** Those who subscribed by topic or regular expression have the record already. */
  #handleLateRecord(record: ReceivedRecord): void {
    for (const receiver of this.#routeOf(record.topic).receivers) {
      if (receiver.serverPattern.kind === 'component') receiver.handleRecord(record, false);
    }
    this.#remember(record);
  }

  #routeOf(topic: string): Route {
    let route = this.#routes.get(topic);
    if (route === undefined) {
      const groups = [...this.#groups.values()].filter((group) => this.#selects(group, topic));
      route = {
        receivers: groups.flatMap(({ members }) => [...members]),
        countAtMaster: groups.filter(({ pattern }) => pattern.kind !== 'component').length,
      };
      if (this.#routes.size >= MAX_REMEMBERED_TOPICS) this.#routes.clear();
      this.#routes.set(topic, route);
    }
    return route;
  }

  #selects({ pattern, match }: Group, topic: string): boolean {
    if (pattern.kind === 'topic') return pattern.topic === topic;
    if (pattern.kind === 'regex') return match?.(topic) === true;
    return this.#componentTopics.has(pattern.key, topic);
  }

  #forget(topic: string): void {
    this.#newest.delete(topic);
    this.#transferredTopics.delete(topic);
  }

  #remember(record: ReceivedRecord): void {
    this.#transferredTopics.delete(record.topic);
    if (this.#newest.size >= MAX_REMEMBERED_TOPICS && !this.#newest.has(record.topic)) {
      const [oldest] = this.#newest.keys();
      if (oldest !== undefined) this.#newest.delete(oldest);
    }
    this.#newest.set(record.topic, record);
  }

  #addProfile(key: string, profile: ComponentProfile): void {
    this.#componentTopics.add(key, profile);
    if (this.#deviceNews.length > 0) return;
    const added = this.subscribe({ topic: INFO_TOPICS.newDevice }, { format: 'device' });
    const removed = this.subscribe({ topic: INFO_TOPICS.deleteDevice }, { format: 'device' });
    added.onRecord(({ value }) => this.#componentTopics.handleNewDevice(value));
    removed.onRecord(() => void this.#componentTopics.refresh().catch(() => undefined));
    this.#deviceNews = [added, removed];
  }

  #removeProfile(key: string): void {
    this.#componentTopics.remove(key);
    this.#handleComponentTopics();
    const hasProfiles = [...this.#groups.values()].some(
      ({ pattern }) => pattern.kind === 'component',
    );
    if (hasProfiles) return;
    const news = this.#deviceNews;
    this.#deviceNews = [];
    for (const subscription of news) void subscription.close();
  }

  #handleComponentTopics(): void {
    this.#routes.clear();
    const wanted = this.#takesComponents ? new Set<string>() : this.#componentTopics.topics();
    for (const [topic, substitute] of this.#substitutes) {
      if (wanted.has(topic)) continue;
      this.#substitutes.delete(topic);
      void substitute.close();
    }
    for (const topic of wanted) {
      if (this.#substitutes.has(topic)) continue;
      const substitute = this.subscribe({ topic }, { bufferSize: 1 });
      this.#substitutes.set(
        topic,
        substitute.onRecord(() => undefined),
      );
    }
  }
}

function matchAtHand(pattern: ServerPattern): TopicMatch | undefined {
  return pattern.kind === 'regex' ? pattern.matcher.match : undefined;
}

function notLoaded(source: string, cause: unknown): ServiceError {
  if (cause instanceof TypeError) {
    return new ServiceError('invalid_argument', `${cause.message}.`, { cause });
  }
  const reason = cause instanceof Error ? cause.message : String(cause);
  return new ServiceError(
    'unavailable',
    `The code that matches the regular expression "${source}" could not be loaded: ${reason}.`,
    { cause },
  );
}

/** The rate the master is asked for: the fastest of the group, 0 for every record. [TD-28] */
function rateOf({ members }: Group): number {
  const fastestHz = Math.max(...[...members].map(({ maxRateHz }) => maxRateHz));
  return fastestHz === Infinity ? 0 : fastestHz;
}

function emptyRecord(topic: string): EmptyRecord {
  return { topic, format: undefined, value: undefined, timestampMs: undefined, clientId: '' };
}
