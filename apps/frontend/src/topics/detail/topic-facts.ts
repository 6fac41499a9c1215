import type { TopicRate } from '../../connection/topic-rates.ts';
import { formatBytes } from '../../ui/readouts/format-bytes.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import { formatRate } from '../../ui/readouts/format-rate.ts';
import { formatAge } from '../../ui/readouts/format-time.ts';
import { NO_VALUE, type Readout } from '../../ui/readouts/readout.ts';

/** Statistics of a topic, as text. */
export interface TopicFacts {
  readonly rate: Readout;
  readonly age: Readout;
  readonly bandwidth: Readout;
  /** Records that slow subscribers did not receive, since the topic appeared. */
  readonly dropped: Readout;
  readonly isDropping: boolean;
  readonly subscribers: Readout;
  readonly publisherId: string;
  /** True when the topic has had a record. */
  readonly isPublished: boolean;
}

const NOTHING: TopicFacts = {
  rate: NO_VALUE,
  age: NO_VALUE,
  bandwidth: NO_VALUE,
  dropped: NO_VALUE,
  isDropping: false,
  subscribers: NO_VALUE,
  publisherId: '',
  isPublished: false,
};

/** @param nowMs epoch milliseconds, master's clock */
export function topicFacts(rate: TopicRate | undefined, nowMs: number): TopicFacts {
  if (rate === undefined) return NOTHING;
  const { statistic, hz, bytesPerSecond, droppedPerSecond } = rate;
  return {
    rate: hz === undefined ? NO_VALUE : { digits: formatRate(hz), unit: 'Hz' },
    age: statistic.publishedMs === 0 ? NO_VALUE : formatAge(nowMs - statistic.publishedMs),
    bandwidth: bytesPerSecond === undefined ? NO_VALUE : formatBytes(bytesPerSecond, 'B/s'),
    dropped: { digits: formatNumber(statistic.dropped) },
    isDropping: (droppedPerSecond ?? 0) > 0,
    subscribers: { digits: formatNumber(statistic.subscribers) },
    publisherId: statistic.publisherId,
    isPublished: statistic.publishedMs > 0,
  };
}

/** State of a topic for a reader. */
export type TopicLife = 'waiting' | 'live' | 'ended';

/**
 * @param rate the master's statistics; `undefined` when it does not know the topic
 * @param heardMs time at which the newest record arrived; `undefined` before the first
 * @param countedMs time of the statistics, by the same clock; 0 before the first
 */
export function lifeOf(
  rate: TopicRate | undefined,
  heardMs: number | undefined,
  countedMs: number,
): TopicLife {
  const hasValue = rate !== undefined && rate.statistic.dataFormat !== '';
  if (hasValue) return 'live';
  if (heardMs === undefined) return 'waiting';
  // Statistics older than the record say nothing about it.
  return heardMs > countedMs ? 'live' : 'ended';
}
