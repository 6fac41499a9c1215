import type { TopicRecord } from '@ubii/proto';
import type { HistoryLimits } from './history-limits.ts';
import { TopicHistory } from './topic-history.ts';

/** Milliseconds since the Unix epoch, this machine's clock, with fractions and never going back. */
export const nowMs = (): number => performance.timeOrigin + performance.now();

/** What feeds need of the system. */
export interface FeedPorts {
  /** @returns how to end it */
  subscribe(topic: string, onRecord: (record: TopicRecord) => void): () => void;
  /** When the newest record of a topic was published, this machine's clock; `undefined` when unknown. */
  publishedMs(topic: string): number | undefined;
  readonly limits: HistoryLimits;
}

/** What has come on one topic, and the way to look at it. */
export interface FeedLook {
  readonly topic: string;
  readonly history: TopicHistory;
  /** Subscribes while there are viewers. @returns a function that removes the viewer */
  look(): () => void;
}

/** Where views find the feeds of their topics. */
export interface FeedSource {
  get(topic: string): FeedLook;
}

/** The records of one topic. Subscribed while there are viewers; its records are kept without viewers. */
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
    };
  }

  #begin(): void {
    let isFirst = true;
    this.#end = this.#ports.subscribe(this.topic, (record) => {
      const arrivalMs = isFirst ? this.#firstArrivalMs(record) : nowMs();
      isFirst = false;
      if (arrivalMs !== undefined) this.history.add(record, arrivalMs);
    });
  }

  /**
   * The first record may be a retained one: it came when the master says, not now.
   * @returns `undefined` for one that is known from an earlier look
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

/** One feed for each topic of a page, so that several views of a topic share it. */
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

  /** Memory of all, bytes, about. */
  get bytes(): number {
    let bytes = 0;
    for (const { history } of this.#feeds.values()) bytes += history.bytes;
    return bytes;
  }

  get size(): number {
    return this.#feeds.size;
  }
}

/** The feeds as one part of a page sees them: while that part is not looked at, neither are its topics. */
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
