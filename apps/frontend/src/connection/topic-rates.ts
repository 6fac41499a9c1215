import type { TopicStatistic, TopicStatistics } from '@ubii/proto';

/** Statistics and rates of a topic: one object for the life of the topic, mutated in place. */
export interface TopicRate {
  readonly statistic: TopicStatistic;
  /** Records per second; `undefined` until two replies arrived, and while disconnected. */
  readonly hz: number | undefined;
  readonly bytesPerSecond: number | undefined;
  /** Records per second that slow subscribers did not receive. */
  readonly droppedPerSecond: number | undefined;
  /** Rate when the newest record arrived: the usual rate of the topic, Hz. */
  readonly usualHz: number | undefined;
}

/** Changes in a reply. */
export interface TopicChanges {
  readonly added: readonly TopicRate[];
  readonly removed: readonly TopicRate[];
}

/** Window for mean rates, milliseconds: short enough to follow changes, long enough for stable digits. */
const WINDOW_MS = 2000;
/** Gap between replies (hidden page, lost connection) after which rates restart, milliseconds. */
const BREAK_MS = 2 * WINDOW_MS;
/** Rates below this are shown as 0, Hz. */
const LOWEST_HZ = 0.05;
/** Number of usual intervals of silence after which a topic has stopped. */
const STOPPED_GAPS = 3;
/** Number of records below which the window is too coarse. */
const FEW = 4;
/** Number of replies in the window, at eight a second. */
const SLOTS = 16;

/**
 * Statistics of a topic at the last replies. All topics share the times of the replies, so that a reply adds three
 * numbers per topic without allocation.
 */
class Track implements TopicRate {
  statistic: TopicStatistic;
  hz: number | undefined;
  bytesPerSecond: number | undefined;
  droppedPerSecond: number | undefined;
  usualHz: number | undefined;
  /** Time since which its statistics are known; counts start at zero there. */
  sinceMs: number;
  /** Mean interval of recent records, milliseconds. */
  gapMs: number | undefined;
  /** True when the newest reply contains it. */
  isNamed = false;
  /** True when the newest reply has more records. */
  hasGrown = false;
  readonly records = new Float64Array(SLOTS);
  readonly bytes = new Float64Array(SLOTS);
  readonly dropped = new Float64Array(SLOTS);

  constructor(statistic: TopicStatistic, sinceMs: number) {
    this.statistic = statistic;
    this.sinceMs = sinceMs;
  }

  /** Rates become unknown. */
  pause(): void {
    this.hz = undefined;
    this.bytesPerSecond = undefined;
    this.droppedPerSecond = undefined;
  }

  /** Restarts counting at zero. */
  restart(nowMs: number): void {
    this.records.fill(this.statistic.records);
    this.bytes.fill(this.statistic.bytes);
    this.dropped.fill(this.statistic.dropped);
    this.sinceMs = nowMs;
  }
}

/** Converts replies of the topic statistics to rates. [EX-11, EX-12] */
export class TopicRates {
  readonly #tracks = new Map<string, Track>();
  readonly #times = new Float64Array(SLOTS);
  /** Index of the newest reply in the rings. */
  #slot = 0;
  /** Number of replies in the rings. */
  #filled = 0;
  #masterTimeMs: number | undefined;
  #cursor = 0;

  get rates(): ReadonlyMap<string, TopicRate> {
    return this.#tracks;
  }

  /** For the next request. */
  get cursor(): number {
    return this.#cursor;
  }

  /** Time of the newest reply, epoch milliseconds of the master's clock. */
  get masterTimeMs(): number | undefined {
    return this.#masterTimeMs;
  }

  apply(reply: TopicStatistics): TopicChanges {
    const nowMs = reply.masterTimeMs;
    const beforeMs = this.#masterTimeMs;
    const hasBreak = reply.reset || beforeMs === undefined || nowMs - beforeMs > BREAK_MS;
    this.#masterTimeMs = nowMs;
    this.#cursor = reply.cursor;
    const removed = reply.removed.flatMap((topic) => this.#remove(topic));
    const added: Track[] = [];
    for (const statistic of reply.elements) {
      const track = this.#tracks.get(statistic.topic);
      if (track !== undefined) {
        noteGap(track, statistic);
        track.hasGrown = statistic.records > track.statistic.records;
        track.statistic = statistic;
        track.isNamed = true;
      } else {
        const created = new Track(statistic, hasBreak ? nowMs : beforeMs);
        created.isNamed = true;
        created.hasGrown = !hasBreak;
        this.#tracks.set(statistic.topic, created);
        added.push(created);
      }
    }
    if (reply.reset) removed.push(...this.#removeUnnamed());
    this.#advance(nowMs, hasBreak);
    return { added, removed };
  }

  /** Without replies, topics stay and their rates become unknown. */
  pause(): void {
    for (const track of this.#tracks.values()) track.pause();
  }

  #remove(topic: string): Track[] {
    const track = this.#tracks.get(topic);
    if (track === undefined) return [];
    this.#tracks.delete(topic);
    return [track];
  }

  /** After a full list, removes topics that it does not contain. */
  #removeUnnamed(): Track[] {
    const gone = [...this.#tracks.values()].filter(({ isNamed }) => !isNamed);
    for (const { statistic } of gone) this.#tracks.delete(statistic.topic);
    return gone;
  }

  #advance(nowMs: number, hasBreak: boolean): void {
    this.#slot = (this.#slot + 1) % SLOTS;
    this.#filled = hasBreak ? 1 : Math.min(this.#filled + 1, SLOTS);
    this.#times[this.#slot] = nowMs;
    const oldest = this.#oldestSlot(nowMs);
    for (const track of this.#tracks.values()) {
      if (hasBreak) track.restart(nowMs);
      track.records[this.#slot] = track.statistic.records;
      track.bytes[this.#slot] = track.statistic.bytes;
      track.dropped[this.#slot] = track.statistic.dropped;
      this.#measure(track, oldest, nowMs);
      track.isNamed = false;
      track.hasGrown = false;
    }
  }

  /** Returns the newest slot that is as old as the window, or the oldest one. */
  #oldestSlot(nowMs: number): number {
    for (let back = 1; back < this.#filled; back++) {
      const slot = (this.#slot - back + SLOTS) % SLOTS;
      if (this.#times[slot]! <= nowMs - WINDOW_MS || back === this.#filled - 1) return slot;
    }
    return this.#slot;
  }

  #measure(track: Track, oldest: number, nowMs: number): void {
    const seconds = (nowMs - Math.max(this.#times[oldest]!, track.sinceMs)) / 1000;
    if (seconds <= 0) return; // First reply after a gap: keep the previous values.
    const { statistic, gapMs } = track;
    const count = statistic.records - track.records[oldest]!;
    track.droppedPerSecond = (statistic.dropped - track.dropped[oldest]!) / seconds;
    if (count < FEW && gapMs !== undefined) {
      // Too few records in the window: the interval between records is more precise.
      const silenceMs = nowMs - statistic.publishedMs;
      const slowHz = 1000 / Math.max(gapMs, silenceMs, 1);
      const hasStopped = silenceMs > Math.max(WINDOW_MS, STOPPED_GAPS * gapMs);
      track.hz = hasStopped || slowHz < LOWEST_HZ ? 0 : slowHz;
      track.bytesPerSecond = track.hz * statistic.valueBytes;
    } else {
      // The first record of a topic is not a stream yet.
      const overSeconds = count < 2 ? Math.max(seconds, WINDOW_MS / 1000) : seconds;
      track.hz = count / overSeconds;
      track.bytesPerSecond = (statistic.bytes - track.bytes[oldest]!) / overSeconds;
    }
    if (track.hasGrown && (count >= 2 || gapMs !== undefined)) track.usualHz = track.hz;
  }
}

function noteGap(track: Track, { records, publishedMs }: TopicStatistic): void {
  const before = track.statistic;
  if (records > before.records && before.publishedMs > 0) {
    const gapMs = (publishedMs - before.publishedMs) / (records - before.records);
    // Exponential smoothing, because events such as button presses are irregular.
    track.gapMs = track.gapMs === undefined ? gapMs : (track.gapMs + gapMs) / 2;
  } else if (records < before.records) {
    track.gapMs = undefined; // The master was restarted.
  }
}
