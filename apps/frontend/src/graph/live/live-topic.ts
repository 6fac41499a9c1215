import type { TopicRecord } from '@ubii/proto';
import type { TopicRate } from '../../connection/topic-rates.ts';
import type { RowValue } from '../../topics/rows/row-value.ts';
import { NO_SPARK, type SparkLine } from '../../topics/rows/sparkline.ts';
import { isStale } from '../../topics/rows/staleness.ts';

/** State of a topic as shown on the canvas. */
export interface LiveTopic {
  /** Records per second; undefined while unknown. */
  readonly hz: number | undefined;
  /** Newest value in one line. */
  readonly text: string | undefined;
  readonly record: TopicRecord | undefined;
  readonly spark: SparkLine;
  /** Age of the newest record; undefined before the first. */
  readonly ageMs: number | undefined;
  readonly isStale: boolean;
  readonly droppedPerSecond: number;
  readonly format: string;
  /** Id of the client that published last. */
  readonly publisherId: string;
}

/**
 * Returns the state of a topic. Its first value arrives before the master's statistics of it.
 * @param nowMs current time of the master's clock, epoch milliseconds
 */
export function liveTopic(
  rate: TopicRate | undefined,
  value: RowValue | undefined,
  isPublisherAway: boolean,
  nowMs: number,
): LiveTopic {
  const { publishedMs = 0, dataFormat = '', publisherId = '' } = rate?.statistic ?? {};
  const record = value?.record;
  const isCounted = rate !== undefined && publishedMs > 0;
  return {
    hz: rate?.hz,
    text: value?.text,
    record,
    spark: value?.spark ?? NO_SPARK,
    ageMs: isCounted ? Math.max(0, nowMs - publishedMs) : record && 0,
    isStale: isCounted && isStale(rate, isPublisherAway, nowMs),
    droppedPerSecond: rate?.droppedPerSecond ?? 0,
    format: dataFormat || (record?.format ?? ''),
    publisherId: publisherId || (isCounted ? '' : (record?.clientId ?? '')),
  };
}

const rateText = ({ hz }: LiveTopic): string | undefined => hz?.toFixed(1);

const isPublished = ({ ageMs }: LiveTopic): boolean => ageMs !== undefined;

/** Whether the visible state differs. */
export function hasChanged(a: LiveTopic, b: LiveTopic): boolean {
  return (
    a.publisherId !== b.publisherId ||
    a.format !== b.format ||
    rateText(a) !== rateText(b) ||
    a.text !== b.text ||
    isPublished(a) !== isPublished(b) ||
    a.spark !== b.spark ||
    a.isStale !== b.isStale ||
    a.droppedPerSecond !== b.droppedPerSecond ||
    (b.isStale && a.ageMs !== b.ageMs)
  );
}
