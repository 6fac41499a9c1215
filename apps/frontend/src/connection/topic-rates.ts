import type { TopicStatistic, TopicStatistics } from '@ubii/proto';

/** A topic's counters with what they mean per second: one object for the life of the topic, renewed in place. */
export interface TopicRate {
  readonly statistic: TopicStatistic;
  /** Records per second; `undefined` until two replies were seen, and while the master is away. */
  readonly hz: number | undefined;
  readonly bytesPerSecond: number | undefined;
  /** Records per second that slow subscribers did not get. */
  readonly droppedPerSecond: number | undefined;
  /** Records per second when the newest record came: what to expect of the topic. */
  readonly usualHz: number | undefined;
}

/** What one reply changed. */
export interface TopicChanges {
  readonly added: readonly TopicRate[];
  readonly removed: readonly TopicRate[];
}

/** Rates are means over this time: short enough to follow, long enough not to flicker. */
const WINDOW_MS = 2000;
/** After a break this long (a hidden page, a lost link) rates start afresh. */
const BREAK_MS = 2 * WINDOW_MS;
/** Below this rate it shows as 0. */
const LOWEST_HZ = 0.05;
/** A topic has stopped when it is silent for this many of its usual gaps. */
const STOPPED_GAPS = 3;
/** Fewer records than this in the window are too coarse to count. */
const FEW = 4;
/** Replies remembered: the window at eight a second. */
const SLOTS = 16;

/**
 * The counters of one topic at the last replies. The times of the replies are the same for all
 * topics, so a reply costs a topic three numbers and no memory.
 */
class Track implements TopicRate {
  statistic: TopicStatistic;
  hz: number | undefined;
  bytesPerSecond: number | undefined;
  droppedPerSecond: number | undefined;
  usualHz: number | undefined;
  /** Since when its counters are known; it had counted nothing before. */
  sinceMs: number;
  /** Mean time between the last records, milliseconds. */
  gapMs: number | undefined;
  /** The newest reply named it. */
  isNamed = false;
  /** The newest reply counted more records. */
  hasGrown = false;
  readonly records = new Float64Array(SLOTS);
  readonly bytes = new Float64Array(SLOTS);
  readonly dropped = new Float64Array(SLOTS);

  constructor(statistic: TopicStatistic, sinceMs: number) {
    this.statistic = statistic;
    this.sinceMs = sinceMs;
  }

  /** Nothing is measured now. */
  pause(): void {
    this.hz = undefined;
    this.bytesPerSecond = undefined;
    this.droppedPerSecond = undefined;
  }

  /** Counts from here, as if nothing had been before. */
  restart(nowMs: number): void {
    this.records.fill(this.statistic.records);
    this.bytes.fill(this.statistic.bytes);
    this.dropped.fill(this.statistic.dropped);
    this.sinceMs = nowMs;
  }
}

/** Turns replies of the topic statistics into rates. [EX-11, EX-12] */
export class TopicRates {
  readonly #tracks = new Map<string, Track>();
  readonly #times = new Float64Array(SLOTS);
  /** Where the newest reply stands in the rings. */
  #slot = 0;
  /** Replies in the rings. */
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

  /** When the newest reply was made: milliseconds since the Unix epoch, master's clock. */
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

  /** No reply comes: what is known of the topics stays, and their rates are unknown. */
  pause(): void {
    for (const track of this.#tracks.values()) track.pause();
  }

  #remove(topic: string): Track[] {
    const track = this.#tracks.get(topic);
    if (track === undefined) return [];
    this.#tracks.delete(topic);
    return [track];
  }

  /** After a full list: what it does not name is gone. */
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

  /** The newest slot that is as old as the window, or the oldest there is. */
  #oldestSlot(nowMs: number): number {
    for (let back = 1; back < this.#filled; back++) {
      const slot = (this.#slot - back + SLOTS) % SLOTS;
      if (this.#times[slot]! <= nowMs - WINDOW_MS || back === this.#filled - 1) return slot;
    }
    return this.#slot;
  }

  #measure(track: Track, oldest: number, nowMs: number): void {
    const seconds = (nowMs - Math.max(this.#times[oldest]!, track.sinceMs)) / 1000;
    if (seconds <= 0) return; // the first after a break: what was known stands
    const { statistic, gapMs } = track;
    const count = statistic.records - track.records[oldest]!;
    track.droppedPerSecond = (statistic.dropped - track.dropped[oldest]!) / seconds;
    if (count < FEW && gapMs !== undefined) {
      // Too few in the window to count: the time between two records says it better.
      const silenceMs = nowMs - statistic.publishedMs;
      const slowHz = 1000 / Math.max(gapMs, silenceMs, 1);
      const hasStopped = silenceMs > Math.max(WINDOW_MS, STOPPED_GAPS * gapMs);
      track.hz = hasStopped || slowHz < LOWEST_HZ ? 0 : slowHz;
      track.bytesPerSecond = track.hz * statistic.valueBytes;
    } else {
      // A topic's first record does not make a stream yet.
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
    // Half of what was before: presses of a button are irregular.
    track.gapMs = track.gapMs === undefined ? gapMs : (track.gapMs + gapMs) / 2;
  } else if (records < before.records) {
    track.gapMs = undefined; // another run of the master
  }
}
