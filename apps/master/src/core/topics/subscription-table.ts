import { ServiceError, type Component } from '@ubii/proto';
import type { Accounts } from '../shares/accounts.ts';
import { Hook } from '../hooks/hook.ts';
import { charge } from '../shares/charge.ts';
import { RESOURCE, type Resource } from '../shares/resources.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { ComponentSelection } from './component-selection.ts';
import type { Pattern } from './pattern.ts';
import type { PatternTable } from './pattern-table.ts';
import type { SelectionTable } from './selection-table.ts';
import type { SharedPattern, SharedSelection, Subscriber, TopicEntry } from './topic-entry.ts';
import { quote } from '../texts/quote.ts';
import { topicFault } from './topic-names.ts';
import type { TopicTable } from './topic-table.ts';

/** Dependencies of a subscription table. */
export interface SubscriptionContext {
  readonly topics: TopicTable;
  readonly patterns: PatternTable;
  readonly selections: SelectionTable;
  readonly limits: LimitWatch;
  readonly accounts: Accounts;
}

/** Something whose subscribers of this master changed; `everything` are those that get every topic. */
export type SubscriptionChange = TopicEntry | SharedPattern | SharedSelection | 'everything';

/** All subscriptions by client and topic [TD-20]. Subscribing returns the topics whose retained record is to be sent [TD-24]. */
export class SubscriptionTable {
  /** Subscribers of this master, or their rates, changed: other masters need to know. [CU-10] */
  readonly onChange = new Hook<[changed: SubscriptionChange]>();
  readonly #context: SubscriptionContext;

  constructor(context: SubscriptionContext) {
    this.#context = context;
  }

  /** @throws ServiceError when the topic is none, or there are too many. */
  subscribeTopic(subscriber: Subscriber, topic: string, rateHz: number): TopicEntry[] {
    const { topics, limits, accounts } = this.#context;
    const fault = topicFault(topic, limits.limits.topicBytes);
    if (fault === 'is too long') throw this.#tooMany('topicBytes', 'bytes of a topic', subscriber);
    if (fault !== undefined) {
      throw new ServiceError(
        'invalid_argument',
        `${quote(topic)} cannot be subscribed to, because a topic that ${fault} does not exist.`,
      );
    }
    if (subscriber.readRights?.mayRead(topic) === false) {
      throw new ServiceError(
        'permission_denied', // [AC-25]
        `A client that joined with this role cannot subscribe to ${quote(topic)}: it receives its own topics, /${subscriber.clientId}/..., and those it was given.`,
      );
    }
    const { account } = subscriber;
    const isSubscribed = subscriber.topics.has(topics.get(topic)!);
    if (!isSubscribed) accounts.require(account, RESOURCE.subscriptions, 1);
    if (topics.get(topic) === undefined) accounts.require(account, RESOURCE.topics, 1);
    const entry = topics.getOrCreate(topic);
    if (entry.subscribers.get(subscriber) === rateHz) return []; // [TD-23]
    entry.subscribers.set(subscriber, rateHz);
    subscriber.topics.add(entry);
    if (!isSubscribed) account.add(RESOURCE.subscriptions, 1);
    topics.settlePayer(entry);
    topics.markSubscribersChanged(entry);
    if (!subscriber.isPeer) this.onChange.emit(entry);
    return !isSubscribed && this.#reaches(subscriber, entry) ? [entry] : [];
  }

  /** @throws ServiceError when the pattern is refused, or there are too many. */
  subscribePattern(subscriber: Subscriber, source: string, rateHz: number): TopicEntry[] {
    const { topics, patterns, limits } = this.#context;
    let pattern = patterns.get(source);
    const isNew = pattern === undefined || !subscriber.patterns.has(pattern);
    if (isNew) this.#checkPattern(subscriber, source, pattern === undefined);
    try {
      pattern ??= patterns.create(source, topics.values(), subscriber);
    } catch (cause) {
      const reason = cause instanceof Error ? cause.message : String(cause);
      throw new ServiceError(
        'invalid_argument',
        `${quote(source)} is not a regular expression in RE2 syntax: ${reason}.`, // [TD-21]
        { cause },
      );
    }
    if (pattern === undefined) {
      const text =
        'more time than the regular expressions of one client may take (in milliseconds)';
      throw limits.refusal('patternMatchMs', text, subscriber.clientId); // [TD-29]
    }
    const replays = this.#subscribe(subscriber, pattern, subscriber.patterns, rateHz, isNew);
    settle(pattern, RESOURCE.patterns);
    return replays;
  }

  /** @throws ServiceError when there are too many. */
  subscribeComponents(subscriber: Subscriber, profile: Component, rateHz: number): TopicEntry[] {
    const { topics, selections, accounts } = this.#context;
    let selection = selections.get(profile);
    const isNew = selection === undefined || !subscriber.selections.has(selection);
    if (isNew) this.#requireOwn(subscriber, RESOURCE.profiles, subscriber.selections.size);
    if (selection === undefined) accounts.require(subscriber.account, RESOURCE.profiles, 1);
    selection ??= selections.create(profile, (topic) => topics.get(topic));
    const replays = this.#subscribe(subscriber, selection, subscriber.selections, rateHz, isNew);
    settle(selection, RESOURCE.profiles);
    return replays;
  }

  // Unsubscribing without a subscription has no effect. [TD-23]

  unsubscribeTopic(subscriber: Subscriber, topic: string): void {
    const entry = this.#context.topics.get(topic);
    if (entry === undefined || !subscriber.topics.delete(entry)) return;
    entry.subscribers.delete(subscriber);
    subscriber.account.add(RESOURCE.subscriptions, -1);
    this.#context.topics.settlePayer(entry);
    if (!this.isSubscribed(subscriber, entry)) subscriber.outbox.cancelReplay(entry);
    this.#context.topics.markSubscribersChanged(entry);
    this.#context.topics.forgetIfUnused(entry);
    if (!subscriber.isPeer) this.onChange.emit(entry);
  }

  unsubscribePattern(subscriber: Subscriber, source: string): void {
    const pattern = this.#context.patterns.get(source);
    if (pattern === undefined || !subscriber.patterns.delete(pattern)) return;
    this.#unsubscribe(subscriber, pattern);
    settle(pattern, RESOURCE.patterns);
    this.#context.patterns.forgetIfUnused(pattern);
  }

  /** Ends every regular expression of a client. */
  unsubscribePatterns(subscriber: Subscriber): void {
    for (const { source } of [...subscriber.patterns]) this.unsubscribePattern(subscriber, source);
  }

  unsubscribeComponents(subscriber: Subscriber, profile: Component): void {
    const selection = this.#context.selections.get(profile);
    if (selection === undefined || !subscriber.selections.delete(selection)) return;
    this.#unsubscribe(subscriber, selection);
    settle(selection, RESOURCE.profiles);
    this.#context.selections.forgetIfUnused(selection);
  }

  /** A device of this client watches everything [DV-3]. */
  watch(subscriber: Subscriber, deviceId: string): TopicEntry[] {
    subscriber.watchers.add(deviceId);
    const { topics } = this.#context;
    if (!topics.addWatcher(subscriber)) return [];
    if (!subscriber.isPeer) this.onChange.emit('everything');
    return [...topics.values()].filter((entry) => this.#reaches(subscriber, entry));
  }

  unwatch(subscriber: Subscriber, deviceId: string): void {
    if (!subscriber.watchers.delete(deviceId) || subscriber.watchers.size > 0) return;
    this.#context.topics.removeWatcher(subscriber);
    if (!subscriber.isPeer) this.onChange.emit('everything');
  }

  /** A component was registered: profiles may select its topic [TD-27]. */
  addComponent(component: Component): void {
    const { topics, selections } = this.#context;
    const entry = topics.get(component.topic);
    const gained = selections.addComponent(component, entry);
    if (entry === undefined) return;
    if (gained.length > 0) topics.markSubscribersChanged(entry);
    for (const selection of gained) {
      for (const subscriber of selection.subscribers.keys()) {
        if (subscriber.isExtension && this.#reaches(subscriber, entry)) {
          subscriber.outbox.replay(entry, topics.sequence);
        }
      }
    }
  }

  removeComponent(component: Component): void {
    const { topics, selections } = this.#context;
    const entry = topics.get(component.topic);
    const lost = selections.removeComponent(component, entry);
    if (entry !== undefined && lost.length > 0) topics.markSubscribersChanged(entry);
  }

  /** Ends every subscription of a client that is removed. */
  unsubscribeAll(subscriber: Subscriber): void {
    for (const { topic } of [...subscriber.topics]) this.unsubscribeTopic(subscriber, topic);
    this.unsubscribePatterns(subscriber);
    for (const { profile } of [...subscriber.selections]) {
      this.unsubscribeComponents(subscriber, profile);
    }
    for (const deviceId of [...subscriber.watchers]) this.unwatch(subscriber, deviceId);
  }

  /** Whether any subscription of this client selects the topic. */
  isSubscribed(subscriber: Subscriber, entry: TopicEntry): boolean {
    const { topics, patterns, selections, watchers } = subscriber;
    return (
      topics.has(entry) ||
      watchers.size > 0 ||
      entry.patterns.some((pattern) => patterns.has(pattern)) ||
      entry.selections.some((selection) => selections.has(selection))
    );
  }

  /** Topics whose newest record a client is to get when it comes back after a pause [TD-33]. */
  *replayable(subscriber: Subscriber): Iterable<TopicEntry> {
    for (const entry of subscriber.topics) if (this.#reaches(subscriber, entry)) yield entry;
    if (!subscriber.isExtension) return;
    for (const { entries } of [...subscriber.patterns, ...subscriber.selections]) {
      for (const entry of entries) if (this.#reaches(subscriber, entry)) yield entry;
    }
  }

  /** Handles a change of the topics that a client may receive. [AC-25] */
  handleRightsChanged(subscriber: Subscriber): void {
    for (const entry of this.#context.topics.values()) {
      if (!this.#reaches(subscriber, entry)) subscriber.outbox.cancelReplay(entry);
    }
    this.#context.topics.markAllSubscribersChanged();
  }

  #subscribe<S extends SharedPattern | SharedSelection>(
    subscriber: Subscriber,
    subscribed: S,
    own: Set<S>,
    rateHz: number,
    isNew: boolean,
  ): TopicEntry[] {
    if (subscribed.subscribers.get(subscriber) === rateHz) return []; // [TD-23]
    subscribed.subscribers.set(subscriber, rateHz);
    own.add(subscribed);
    if (!subscriber.isPeer) this.onChange.emit(subscribed);
    for (const entry of subscribed.entries) this.#context.topics.markSubscribersChanged(entry);
    if (!isNew || !subscriber.isExtension) return [];
    return [...subscribed.entries].filter((entry) => this.#reaches(subscriber, entry)); // [TD-24]
  }

  #unsubscribe(subscriber: Subscriber, subscribed: SharedPattern | SharedSelection): void {
    subscribed.subscribers.delete(subscriber);
    if (!subscriber.isPeer) this.onChange.emit(subscribed);
    for (const entry of subscribed.entries) {
      if (!this.isSubscribed(subscriber, entry)) subscriber.outbox.cancelReplay(entry);
      this.#context.topics.markSubscribersChanged(entry);
    }
  }

  #checkPattern(subscriber: Subscriber, source: string, isUnknown: boolean): void {
    const { limits, accounts } = this.#context;
    if (source.length > limits.limits.patternLength) {
      throw this.#tooMany('patternLength', 'characters of a regular expression', subscriber);
    }
    this.#requireOwn(subscriber, RESOURCE.patterns, subscriber.patterns.size);
    if (isUnknown) accounts.require(subscriber.account, RESOURCE.patterns, 1);
  }

  /** Limit for one client, independent of the account that is charged. */
  #requireOwn({ account }: Subscriber, resource: Resource, used: number): void {
    if (used < account.max(resource)) return;
    throw this.#context.accounts.refusal({ account, resource, level: account, used });
  }

  #reaches(subscriber: Subscriber, entry: TopicEntry): boolean {
    if (subscriber.isPeer && entry.originId !== undefined) return false; // [CU-11]
    if (entry.isExtension && !subscriber.isExtension) return false; // [TD-26]
    return subscriber.readRights?.mayRead(entry.topic) !== false; // [AC-25]
  }

  #tooMany(
    limit: Parameters<LimitWatch['refusal']>[0],
    what: string,
    { clientId }: Subscriber,
  ): ServiceError {
    const { limits } = this.#context;
    return limits.refusal(limit, `more than ${limits.limits[limit]} ${what}`, clientId);
  }
}

/** Charges the earliest subscriber. [AC-80] */
function settle(
  subscribed: Pattern | ComponentSelection,
  resource: typeof RESOURCE.patterns | typeof RESOURCE.profiles,
): void {
  const [first] = subscribed.subscribers.keys();
  charge(subscribed, resource, first?.account);
}
