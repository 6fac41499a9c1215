import type { TopicStatistic, TopicStatistics } from '@ubii/proto';
import type { SubscriptionTable } from './subscription-table.ts';
import { dataFormatOf, type TopicEntry } from './topic-entry.ts';
import type { TopicTable } from './topic-table.ts';

/** The counters of the topics that changed since a cursor [EX-11]. */
export function readTopicStatistics(
  topics: TopicTable,
  subscriptions: SubscriptionTable,
  cursor: number,
  nowMs: number,
): TopicStatistics {
  const { entries, removed, isReset, epoch } = topics.takeChanges(cursor);
  return {
    cursor: epoch,
    reset: isReset,
    elements: entries.map((entry) => statisticOf(entry, subscriptions)),
    removed,
    masterTimeMs: nowMs,
  };
}

function statisticOf(entry: TopicEntry, subscriptions: SubscriptionTable): TopicStatistic {
  const { direct, sampled } = subscriptions.targetsOf(entry);
  return {
    topic: entry.topic,
    dataFormat: dataFormatOf(entry),
    publisherId: entry.publisherId,
    records: entry.records,
    bytes: entry.bytes,
    dropped: entry.dropped,
    publishedMs: entry.publishedMs,
    subscribers: direct.length + sampled.length,
    valueBytes: entry.record?.byteLength ?? 0,
  };
}
