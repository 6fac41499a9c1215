import { Hook } from '../hooks/hook.ts';
import type { Account } from '../shares/account.ts';
import { charge } from '../shares/charge.ts';
import { RESOURCE } from '../shares/resources.ts';
import { computeTargets, ratesBySubscriber } from './targets.ts';
import { TopicEntry, type Subscriber, type Targets, type TopicOwner } from './topic-entry.ts';

/** Matching that runs when a topic is created, and is undone when it is removed. */
export interface TopicMatching {
  attach(entry: TopicEntry): void;
  detach(entry: TopicEntry): void;
}

/** All topics: their values, their owners, who receives them, and what changed since when. */
export class TopicTable {
  readonly #entries = new Map<string, TopicEntry>();
  readonly #matching: readonly TopicMatching[];
  readonly #keptRemovals: number;
  readonly #master: Account;
  /** Called when a topic loses its value. */
  readonly onEnd = new Hook<[TopicEntry]>();
  /** Receive every topic. */
  readonly #watchers = new Set<Subscriber>();
  #removals: { topic: string; epoch: number }[] = [];
  #retainedBytes = 0;
  #sequence = 0;
  #epoch: number;
  #firstEpoch: number;

  /**
   * @param matching Asked in this order.
   * @param firstEpoch Where the epochs of the statistics begin: beyond those of every earlier run.
   * @param keptRemovals Forgotten topics remembered for the statistics.
   * @param master Pays for topics that belong to no client.
   */
  constructor(
    matching: readonly TopicMatching[],
    firstEpoch: number,
    keptRemovals: number,
    master: Account,
  ) {
    this.#matching = matching;
    this.#firstEpoch = firstEpoch;
    this.#epoch = firstEpoch;
    this.#keptRemovals = keptRemovals;
    this.#master = master;
  }

  get size(): number {
    return this.#entries.size;
  }

  get retainedBytes(): number {
    return this.#retainedBytes;
  }

  /** Number of the newest record of all. */
  get sequence(): number {
    return this.#sequence;
  }

  /** The epoch of the statistics that goes on now. */
  get epoch(): number {
    return this.#epoch;
  }

  values(): Iterable<TopicEntry> {
    return this.#entries.values();
  }

  get(topic: string): TopicEntry | undefined {
    return this.#entries.get(topic);
  }

  /** The entry of this topic; patterns are matched now if it is a new one [TD-22]. */
  getOrCreate(topic: string): TopicEntry {
    let entry = this.#entries.get(topic);
    if (entry === undefined) {
      entry = new TopicEntry(topic);
      entry.changedEpoch = this.#epoch;
      this.#entries.set(topic, entry);
      for (const matching of this.#matching) matching.attach(entry);
    }
    return entry;
  }

  /** Makes `record` the retained value. The bytes belong to the table from now on. */
  store(entry: TopicEntry, record: Uint8Array, valueField: number, nowMs: number): void {
    const growth = record.byteLength - (entry.record?.byteLength ?? 0);
    const isFirst = entry.record === undefined;
    entry.record = record;
    if (isFirst) this.settlePayer(entry);
    if (growth !== 0) {
      this.#retainedBytes += growth;
      entry.payer!.add(RESOURCE.retainedBytes, growth);
    }
    entry.valueField = valueField;
    entry.sequence = ++this.#sequence;
    entry.publishedMs = nowMs;
    entry.records++;
    entry.bytes += record.byteLength;
    entry.changedEpoch = this.#epoch;
  }

  /**
   * Finds again who pays for a topic [AC-80]: while it has a value, its owner or the master; else the client
   * that subscribed to it longest ago.
   */
  settlePayer(entry: TopicEntry): void {
    const hasValue = entry.record !== undefined;
    const [first] = hasValue ? [] : entry.subscribers.keys();
    const payer = hasValue ? (entry.owner?.account ?? this.#master) : first?.account;
    charge(entry, RESOURCE.topics, payer);
  }

  /** Makes `owner` the owner of a topic that has no owner yet. Call it before the first value is stored. */
  own(entry: TopicEntry, owner: TopicOwner): void {
    entry.owner = owner;
    owner.ownedTopics.add(entry);
  }

  /** Gives a topic with a value another owner, who pays for both from now on [TD-43]. */
  transfer(entry: TopicEntry, owner: TopicOwner): void {
    const bytes = entry.record?.byteLength ?? 0;
    entry.payer?.add(RESOURCE.retainedBytes, -bytes);
    entry.owner?.ownedTopics.delete(entry);
    this.own(entry, owner);
    this.settlePayer(entry);
    entry.payer?.add(RESOURCE.retainedBytes, bytes);
  }

  /**
   * Deletes the value; subscriptions stand [TD-25]. One that came from another master ends there: here it only
   * loses its owner. [CU-14]
   */
  deleteValue(entry: TopicEntry): void {
    if (entry.record === undefined) return;
    if (entry.originId !== undefined && entry.owner !== undefined) this.disown(entry);
    else this.#deleteValue(entry);
  }

  /** Deletes a value that came from another master, whichever client owns it here. */
  dropForeign(entry: TopicEntry): void {
    if (entry.record === undefined || entry.originId === undefined) return;
    if (entry.owner !== undefined) this.disown(entry);
    this.#deleteValue(entry);
  }

  /** Makes a value one without an owner: it counts for the master. */
  disown(entry: TopicEntry): void {
    const bytes = entry.record!.byteLength;
    entry.payer?.add(RESOURCE.retainedBytes, -bytes);
    entry.owner!.ownedTopics.delete(entry);
    entry.owner = undefined;
    this.settlePayer(entry);
    entry.payer?.add(RESOURCE.retainedBytes, bytes);
  }

  #deleteValue(entry: TopicEntry): void {
    if (entry.record === undefined) return;
    this.#retainedBytes -= entry.record.byteLength;
    entry.payer?.add(RESOURCE.retainedBytes, -entry.record.byteLength);
    entry.record = undefined;
    entry.owner?.ownedTopics.delete(entry);
    entry.owner = undefined;
    this.settlePayer(entry);
    entry.changedEpoch = this.#epoch;
    // Notify modules that use it, here and on nodes, and masters with subscribers. [TD-42] [CU-14]
    const { direct, sampled, ownDirect, ownSampled } = this.targetsOf(entry);
    const isOwn = entry.originId === undefined;
    const count = isOwn ? direct.length : ownDirect;
    for (let i = 0; i < count; i++) direct[i]!.handleGone(entry);
    for (const sample of isOwn ? sampled.slice(ownSampled) : []) sample.sampler.handleGone(sample);
    entry.originId = undefined;
    this.onEnd.emit(entry);
    this.forgetIfUnused(entry);
  }

  /** Forgets a topic that has neither value nor subscription by topic [TD-41]. */
  forgetIfUnused(entry: TopicEntry): void {
    if (entry.record !== undefined || entry.subscribers.size > 0) return;
    if (this.#entries.get(entry.topic) !== entry) return;
    this.#entries.delete(entry.topic);
    charge(entry, RESOURCE.topics, undefined);
    for (const matching of this.#matching) matching.detach(entry);
    if (entry.isExtension) return; // [EX-15]
    this.#removals.push({ topic: entry.topic, epoch: this.#epoch });
    if (this.#removals.length > 2 * this.#keptRemovals) {
      this.#firstEpoch = this.#removals[this.#keptRemovals - 1]!.epoch;
      this.#removals = this.#removals.slice(this.#keptRemovals);
    }
  }

  /** Subscribers that receive the records of this topic; computed when subscriptions or topics changed, else at hand. */
  targetsOf(entry: TopicEntry): Targets {
    if (entry.areTargetsStale) {
      entry.areTargetsStale = false;
      entry.targets = computeTargets(entry, this.#watchers);
    }
    return entry.targets!;
  }

  /** Ids of those who get the records of this topic, each once. */
  subscriberIds(entry: TopicEntry): Set<string> {
    return new Set(
      [...ratesBySubscriber(entry, this.#watchers).keys()].map(({ clientId }) => clientId),
    );
  }

  /** Whether a subscriber of this master receives every topic. */
  get isWatched(): boolean {
    for (const { isPeer } of this.#watchers) if (!isPeer) return true;
    return false;
  }

  /** Makes the subscriber receive every topic. Returns false when it does already. */
  addWatcher(subscriber: Subscriber): boolean {
    if (this.#watchers.has(subscriber)) return false;
    this.#watchers.add(subscriber);
    this.markAllSubscribersChanged();
    return true;
  }

  removeWatcher(subscriber: Subscriber): void {
    this.#watchers.delete(subscriber);
    this.markAllSubscribersChanged();
  }

  /** Its subscribers changed: targets have to be computed again. */
  markSubscribersChanged(entry: TopicEntry): void {
    entry.areTargetsStale = true;
    entry.changedEpoch = this.#epoch;
  }

  markAllSubscribersChanged(): void {
    for (const entry of this.#entries.values()) this.markSubscribersChanged(entry);
  }

  /** A subscriber did not get a record of this topic [TD-34]. */
  countDropped(entry: TopicEntry): void {
    entry.dropped++;
    entry.changedEpoch = this.#epoch;
  }

  /**
   * Topics that changed and topics that were forgotten in epochs after `epoch`, and the epoch that ends
   * with this call. Everything, with `isReset`, when it cannot be told what changed since [EX-12]. The
   * cost is here, and a record costs one number [EX-14].
   */
  takeChanges(epoch: number): {
    entries: TopicEntry[];
    removed: string[];
    isReset: boolean;
    epoch: number;
  } {
    const isReset = !(epoch >= this.#firstEpoch && epoch < this.#epoch);
    const entries: TopicEntry[] = [];
    for (const entry of this.#entries.values()) {
      if (!entry.isExtension && (isReset || entry.changedEpoch > epoch)) entries.push(entry);
    }
    const removed = new Set<string>();
    for (let i = this.#removals.length - 1; i >= 0 && !isReset; i--) {
      const removal = this.#removals[i]!;
      if (removal.epoch <= epoch) break;
      // Topics that exist again are in the list above.
      if (!this.#entries.has(removal.topic)) removed.add(removal.topic);
    }
    return { entries, removed: [...removed], isReset, epoch: this.#epoch++ };
  }
}
