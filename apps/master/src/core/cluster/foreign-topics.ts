import {
  SERVICES,
  type Init,
  type ServiceReply,
  type ServiceRequest,
  type TopicStatistic,
  type TopicStatistics,
} from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { CallerFacts } from '../ports/caller-facts.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import { readTopicStatistics, statisticOf } from '../topics/topic-statistics.ts';

/** Statistics of other masters are asked for at most so often, milliseconds. */
const REFRESH_MS = 400;
/** Topics that were forgotten elsewhere and are remembered as such. */
const MAX_REMOVALS = 10_000;

/** Dependencies of the topics of other masters. */
export interface ForeignTopicsContext {
  readonly clock: Clock;
  readonly topics: TopicTable;
  /** Ids of the other masters. */
  readonly masterIds: () => Iterable<string>;
  readonly call: (
    masterId: string,
    request: ServiceRequest,
    facts: CallerFacts,
  ) => Promise<ServiceReply | undefined>;
}

interface KnownTopic {
  readonly statistic: TopicStatistic;
  /** Epoch of the statistics of this master in which it changed. */
  readonly epoch: number;
}

/** Topics of one other master, as last received. */
interface KnownTopics {
  cursor: number;
  readonly topics: Map<string, KnownTopic>;
}

/** Counters of the topics of all masters, kept only while a client asks for them. [CU-29] */
export class ForeignTopics {
  readonly #context: ForeignTopicsContext;
  readonly #masters = new Map<string, KnownTopics>();
  #removals: { readonly topic: string; readonly epoch: number }[] = [];
  /** Removals before this epoch are not known any more. */
  #firstEpoch = 0;
  #refreshing: Promise<void> | undefined = undefined;
  #refreshedMs = Number.NEGATIVE_INFINITY;

  constructor(context: ForeignTopicsContext) {
    this.#context = context;
  }

  /** The counters of topics of all masters that changed since a cursor. [EX-11] */
  async read(cursor: number, facts: CallerFacts): Promise<Init<TopicStatistics>> {
    await this.#refresh(facts);
    const { topics, clock } = this.#context;
    const own = readTopicStatistics(topics, cursor < this.#firstEpoch ? 0 : cursor, clock.nowMs());
    const changed = new Set(own.elements.map(({ topic }) => topic));
    const removed = new Set(own.removed);
    for (const { topics: known } of this.#masters.values()) {
      for (const [topic, { epoch }] of known) {
        if (own.reset || epoch > cursor || removed.has(topic)) changed.add(topic);
      }
    }
    for (const { topic, epoch } of this.#removals) {
      if (own.reset || epoch <= cursor) continue;
      if (this.#isKnown(topic)) changed.add(topic);
      else removed.add(topic);
    }
    for (const topic of changed) removed.delete(topic);
    return {
      ...own,
      elements: [...changed].map((topic) => this.#statisticOf(topic)),
      removed: [...removed],
    };
  }

  #isKnown(topic: string): boolean {
    return (
      this.#context.topics.get(topic) !== undefined ||
      [...this.#masters.values()].some(({ topics }) => topics.has(topic))
    );
  }

  /** Of all masters that have the topic: the newest value, all subscribers, and who had most records. */
  #statisticOf(topic: string): TopicStatistic {
    const { topics } = this.#context;
    const entry = topics.get(topic);
    const all = entry === undefined ? [] : [statisticOf(entry, topics)];
    for (const known of this.#masters.values()) {
      const statistic = known.topics.get(topic)?.statistic;
      if (statistic !== undefined) all.push(statistic);
    }
    return all.reduce((one, other) => ({
      ...(other.publishedMs > one.publishedMs ? other : one),
      // A record that crossed was counted at both.
      records: Math.max(one.records, other.records),
      bytes: Math.max(one.bytes, other.bytes),
      dropped: one.dropped + other.dropped,
      subscribers: one.subscribers + other.subscribers,
    }));
  }

  #refresh(facts: CallerFacts): Promise<void> {
    const nowMs = this.#context.clock.monotonicMs();
    if (this.#refreshing === undefined && nowMs - this.#refreshedMs < REFRESH_MS) {
      return Promise.resolve();
    }
    return (this.#refreshing ??= this.#askAll(facts).finally(() => {
      this.#refreshing = undefined;
      this.#refreshedMs = this.#context.clock.monotonicMs();
    }));
  }

  async #askAll(facts: CallerFacts): Promise<void> {
    const ids = new Set(this.#context.masterIds());
    for (const id of this.#masters.keys()) if (!ids.has(id)) this.#forget(id);
    await Promise.all([...ids].map((id) => this.#ask(id, facts)));
  }

  async #ask(id: string, facts: CallerFacts): Promise<void> {
    const known = this.#masters.get(id) ?? { cursor: 0, topics: new Map<string, KnownTopic>() };
    const { topic } = SERVICES.topicStatistics;
    const request = { topic, topicStatisticsRequest: { cursor: known.cursor } } as ServiceRequest;
    const reply = (await this.#context.call(id, request, facts))?.topicStatistics;
    if (reply === undefined) return;
    this.#masters.set(id, known);
    const { epoch } = this.#context.topics;
    const gone = reply.reset ? new Set(known.topics.keys()) : new Set(reply.removed);
    for (const statistic of reply.elements) {
      gone.delete(statistic.topic);
      known.topics.set(statistic.topic, { statistic, epoch });
    }
    for (const one of gone) this.#remove(known, one, epoch);
    known.cursor = reply.cursor;
  }

  #forget(id: string): void {
    const known = this.#masters.get(id)!;
    this.#masters.delete(id);
    for (const topic of [...known.topics.keys()]) {
      this.#remove(known, topic, this.#context.topics.epoch);
    }
  }

  #remove(known: KnownTopics, topic: string, epoch: number): void {
    if (!known.topics.delete(topic)) return;
    this.#removals.push({ topic, epoch });
    if (this.#removals.length <= 2 * MAX_REMOVALS) return;
    this.#firstEpoch = this.#removals[MAX_REMOVALS - 1]!.epoch;
    this.#removals = this.#removals.slice(MAX_REMOVALS);
  }
}
