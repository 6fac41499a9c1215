import type { TopicStatistic, TopicStatistics } from '@ubii/proto';
import { dataFormatOf, type TopicEntry } from './topic-entry.ts';
import type { TopicTable } from './topic-table.ts';

/** The counters of the topics that changed since a cursor [EX-11]. */
export function readTopicStatistics(
  topics: TopicTable,
  cursor: number,
  nowMs: number,
): TopicStatistics {
  const { entries, removed, isReset, epoch } = topics.takeChanges(cursor);
  return {
    cursor: epoch,
    reset: isReset,
    elements: entries.map((entry) => statisticOf(entry, topics)),
    removed,
    masterTimeMs: nowMs,
  };
}

/** The counters of one topic. */
export function statisticOf(entry: TopicEntry, topics: TopicTable): TopicStatistic {
  const { ownDirect, ownSampled } = topics.targetsOf(entry);
  return {
    topic: entry.topic,
    dataFormat: dataFormatOf(entry),
    publisherId: entry.publisherId,
    records: entry.records,
    bytes: entry.bytes,
    dropped: entry.dropped,
    publishedMs: entry.publishedMs,
    // Other masters say how many theirs are.
    subscribers: ownDirect + ownSampled,
    valueBytes: entry.record?.byteLength ?? 0,
  };
}
