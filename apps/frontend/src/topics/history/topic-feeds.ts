import type { FlightRecord, TopicRecord } from '@ubii/proto';
import { fillPast } from './fill-past.ts';
import type { HistoryLimits } from './history-limits.ts';
import { nowMs } from './page-clock.ts';
import { TopicHistory } from './topic-history.ts';

/** Dependencies of feeds. */
export interface FeedPorts {
  /** @returns a function that unsubscribes */
  subscribe(topic: string, onRecord: (record: TopicRecord) => void): () => void;
  /** Publishing time of a topic's newest record, this computer's clock; `undefined` when unknown. */
  publishedMs(topic: string): number | undefined;
  /** Records that came before the page, oldest first; the times are of this computer's clock. */
  past(topic: string): Promise<readonly FlightRecord[]>;
  /** Gives the page a turn. */
  pause(): Promise<void>;
  readonly limits: HistoryLimits;
}

/** Received records of a topic, and the means to subscribe. */
export interface FeedLook {
  readonly topic: string;
  readonly history: TopicHistory;
  /** Subscribes while there are viewers. @returns a function that removes the viewer */
  look(): () => void;
}

/** Provides the feeds of topics. */
export interface FeedSource {
  get(topic: string): FeedLook;
}

/** Feeds with viewers, by topic. */
const lookedAt = new Map<string, Set<TopicFeed>>();

/** Returns the newest record that a plot or detail of this page has of a topic; `undefined` without one. */
export function newestRecord(topic: string): TopicRecord | undefined {
  let newest: TopicHistory | undefined;
  for (const { history } of lookedAt.get(topic) ?? []) {
    if (history.latestLocalMs > (newest?.latestLocalMs ?? 0)) newest = history;
  }
  return newest?.latest;
}

/** Returns the longest history that this page keeps of a topic now; `undefined` without one. */
export function longestHistory(topic: string): TopicHistory | undefined {
  const sinceMs = ({ records }: TopicHistory): number => records.oldest?.localMs ?? Infinity;
  let longest: TopicHistory | undefined;
  for (const { history } of lookedAt.get(topic) ?? []) {
    if (longest === undefined || sinceMs(history) < sinceMs(longest)) longest = history;
  }
  return longest;
}

/** Records of a topic. Subscribed while there are viewers; records are kept without viewers. */
export class TopicFeed implements FeedLook {
  readonly topic: string;
  readonly history: TopicHistory;
  readonly #ports: FeedPorts;
  #looks = 0;
  #end: (() => void) | undefined;

  constructor(topic: string, ports: FeedPorts) {
    this.topic = topic;
    this.#ports = ports;
    this.history = new TopicHistory(ports.limits);
  }

  get isLookedAt(): boolean {
    return this.#looks > 0;
  }

  look(): () => void {
    this.#looks += 1;
    if (this.#looks === 1) this.#begin();
    let isDone = false;
    return () => {
      if (isDone) return;
      isDone = true;
      this.#looks -= 1;
      if (this.#looks > 0) return;
      this.#end?.();
      this.#end = undefined;
      const others = lookedAt.get(this.topic);
      others?.delete(this);
      if (others?.size === 0) lookedAt.delete(this.topic);
    };
  }

  #begin(): void {
    const all = lookedAt.get(this.topic) ?? new Set();
    lookedAt.set(this.topic, all.add(this));
    if (this.history.count === 0) void this.#fillPast();
    let isFirst = true;
    this.#end = this.#ports.subscribe(this.topic, (record) => {
      const arrivalMs = isFirst ? this.#firstArrivalMs(record) : nowMs();
      isFirst = false;
      if (arrivalMs !== undefined) this.history.add(record, arrivalMs);
    });
  }

  /** Takes what came before the page, as far as it can be had. */
  async #fillPast(): Promise<void> {
    const past = await this.#ports.past(this.topic);
    await fillPast(this.history, past, () => this.#ports.pause());
  }

  /**
   * The first record may be a retained one: take the master's time for it.
   * @returns `undefined` for a record that was received before
   */
  #firstArrivalMs(record: TopicRecord): number | undefined {
    const now = nowMs();
    const cameMs = this.#ports.publishedMs(record.topic) ?? record.timestampMs;
    const arrivalMs = Math.min(now, cameMs ?? now);
    const { latest, latestLocalMs } = this.history;
    const isKnown =
      latest !== undefined &&
      (record.timestampMs === undefined
        ? arrivalMs <= latestLocalMs
        : record.timestampMs === latest.timestampMs);
    return isKnown ? undefined : Math.max(arrivalMs, latestLocalMs);
  }
}

/** One feed per topic of a page, shared by all views of the topic. */
export class TopicFeeds implements FeedSource {
  readonly #ports: FeedPorts;
  readonly #feeds = new Map<string, TopicFeed>();

  constructor(ports: FeedPorts) {
    this.#ports = ports;
  }

  get(topic: string): TopicFeed {
    let feed = this.#feeds.get(topic);
    if (!feed) this.#feeds.set(topic, (feed = new TopicFeed(topic, this.#ports)));
    return feed;
  }

  /** Removes topics without viewers that are not in `topics`. */
  keepOnly(topics: ReadonlySet<string>): void {
    for (const [topic, feed] of this.#feeds) {
      if (!topics.has(topic) && !feed.isLookedAt) this.#feeds.delete(topic);
    }
  }

  /** Estimated memory of all feeds, bytes. */
  get bytes(): number {
    let bytes = 0;
    for (const { history } of this.#feeds.values()) bytes += history.bytes;
    return bytes;
  }

  get size(): number {
    return this.#feeds.size;
  }
}

/** The feeds for one part of a page; while that part is hidden, its topics have no viewers. */
export class FeedScope implements FeedSource {
  readonly #source: FeedSource;
  readonly #looks = new Set<{ readonly feed: FeedLook; stop: (() => void) | undefined }>();
  #isActive = false;

  constructor(source: FeedSource) {
    this.#source = source;
  }

  setActive(isActive: boolean): void {
    if (isActive === this.#isActive) return;
    this.#isActive = isActive;
    for (const look of this.#looks) {
      look.stop?.();
      look.stop = isActive ? look.feed.look() : undefined;
    }
  }

  get(topic: string): FeedLook {
    const feed = this.#source.get(topic);
    return {
      topic,
      history: feed.history,
      look: () => {
        const look = { feed, stop: this.#isActive ? feed.look() : undefined };
        this.#looks.add(look);
        return () => {
          look.stop?.();
          this.#looks.delete(look);
        };
      },
    };
  }
}
