import type { TopicStatistic, TopicStatistics } from '@ubii/proto';

/** A topic's counters with what they mean per second. */
export interface TopicRate {
  readonly statistic: TopicStatistic;
  /** Records per second; `undefined` until two replies were seen. */
  readonly hz: number | undefined;
  readonly bytesPerSecond: number | undefined;
  /** Records per second that slow subscribers did not get. */
  readonly droppedPerSecond: number | undefined;
}

interface Point {
  readonly timeMs: number;
  readonly records: number;
  readonly bytes: number;
  readonly dropped: number;
}

interface Track {
  /** Oldest first: one older than the window, the rest within it. */
  points: Point[];
  /** Mean time between the last two changes of the counter, milliseconds. */
  gapMs: number | undefined;
}

/** Rates are means over this time: short enough to follow, long enough not to flicker. */
const WINDOW_MS = 2000;
/** Below this rate it shows as 0 and the topic rests. */
const LOWEST_HZ = 0.05;

/** Turns replies of the topic statistics into rates. [EX-11, EX-12] */
export class TopicRates {
  readonly #rates = new Map<string, TopicRate>();
  readonly #tracks = new Map<string, Track>();
  /** Topics whose rate is above 0 or still unknown: they change even when no reply names them. */
  readonly #moving = new Set<string>();
  #lastMs: number | undefined;
  #cursor = 0;

  get rates(): ReadonlyMap<string, TopicRate> {
    return this.#rates;
  }

  /** For the next request. */
  get cursor(): number {
    return this.#cursor;
  }

  apply(reply: TopicStatistics): void {
    if (reply.reset) this.#clear();
    for (const topic of reply.removed) this.#remove(topic);
    const nowMs = reply.masterTimeMs;
    const named = new Set<string>();
    for (const statistic of reply.elements) {
      named.add(statistic.topic);
      this.#update(statistic, nowMs, reply.reset);
    }
    for (const topic of [...this.#moving]) {
      const rate = this.#rates.get(topic);
      if (rate && !named.has(topic)) this.#update(rate.statistic, nowMs, false);
    }
    this.#lastMs = nowMs;
    this.#cursor = reply.cursor;
  }

  #clear(): void {
    this.#rates.clear();
    this.#tracks.clear();
    this.#moving.clear();
    this.#lastMs = undefined;
  }

  #remove(topic: string): void {
    this.#rates.delete(topic);
    this.#tracks.delete(topic);
    this.#moving.delete(topic);
  }

  #update(statistic: TopicStatistic, nowMs: number, isFirst: boolean): void {
    const { topic, records, bytes, dropped } = statistic;
    const track = this.#tracks.get(topic) ?? this.#newTrack(isFirst);
    this.#tracks.set(topic, track);
    const before = this.#rates.get(topic)?.statistic;
    if (before && records > before.records && before.publishedMs > 0) {
      track.gapMs = (statistic.publishedMs - before.publishedMs) / (records - before.records);
    }
    track.points.push({ timeMs: nowMs, records, bytes, dropped });
    while (track.points.length > 2 && track.points[1]!.timeMs <= nowMs - WINDOW_MS) {
      track.points.shift();
    }
    const rate = { statistic, ...this.#measure(track, statistic, nowMs) };
    this.#rates.set(topic, rate);
    if (rate.hz === undefined || rate.hz >= LOWEST_HZ) this.#moving.add(topic);
    else this.#moving.delete(topic);
  }

  /** A topic that appears between two replies had counted nothing at the earlier one. */
  #newTrack(isFirst: boolean): Track {
    const isNew = !isFirst && this.#lastMs !== undefined;
    const points = isNew ? [{ timeMs: this.#lastMs!, records: 0, bytes: 0, dropped: 0 }] : [];
    return { points, gapMs: undefined };
  }

  #measure(track: Track, statistic: TopicStatistic, nowMs: number): Omit<TopicRate, 'statistic'> {
    const oldest = track.points[0]!;
    const newest = track.points.at(-1)!;
    const seconds = (newest.timeMs - oldest.timeMs) / 1000;
    if (seconds <= 0) {
      return { hz: undefined, bytesPerSecond: undefined, droppedPerSecond: undefined };
    }
    const droppedPerSecond = (newest.dropped - oldest.dropped) / seconds;
    const count = newest.records - oldest.records;
    if (count < 2 && track.gapMs !== undefined) {
      // Too few in the window to count: the time between two records says it better.
      const slowHz = 1000 / Math.max(track.gapMs, nowMs - statistic.publishedMs, 1);
      const hz = slowHz < LOWEST_HZ ? 0 : slowHz;
      return { hz, bytesPerSecond: hz * statistic.valueBytes, droppedPerSecond };
    }
    return {
      hz: count / seconds,
      bytesPerSecond: (newest.bytes - oldest.bytes) / seconds,
      droppedPerSecond,
    };
  }
}
