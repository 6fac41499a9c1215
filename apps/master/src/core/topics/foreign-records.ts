import type { Counters } from '../counters/counters.ts';
import type { Limits } from '../limits/index.ts';
import { isSharedTopic } from './topic-names.ts';
import { isNewer } from './stamps.ts';
import type { KeptValues } from './kept-values.ts';
import type { Publication } from './publication.ts';
import type { RecordTap } from './record-tap.ts';
import type { ReplayedTopics } from './replayed-topics.ts';
import { isEventField, type TopicEntry } from './topic-entry.ts';
import { topicFault } from './topic-names.ts';
import type { TopicTable } from './topic-table.ts';

/** Dependencies of records that other masters send. */
export interface ForeignContext {
  /** Id of this master. */
  readonly id: string;
  readonly topics: TopicTable;
  readonly limits: Limits;
  readonly counters: Counters;
  readonly tap: RecordTap;
  readonly replayed: ReplayedTopics;
  readonly kept: KeptValues;
}

/** Where a record was published, and when compared with others of its topic. */
export interface Origin {
  /** Id of the master that it came from. */
  readonly masterId: string;
  readonly publisherId: string;
  readonly stamp: number;
  /** It is the value that stands there, and not one that was just published. */
  readonly isValue: boolean;
}

/**
 * Gives a record of another master to subscribers of this one, and to no other master [CU-11]. It becomes the value
 * of its topic if none is newer [CU-12].
 *
 * @param publication without a client
 */
export function publishForeign(
  context: ForeignContext,
  publication: Publication,
  origin: Origin,
): void {
  const { topics, replayed } = context;
  const { topic, valueField } = publication;
  if (!isSharedTopic(topic)) return;
  // Existing topics were checked when they were created.
  const isNew = topics.get(topic) === undefined;
  if (isNew && topicFault(topic, context.limits.topicBytes) !== undefined) return;
  if (valueField === 0) return endForeign(topics, topics.get(topic), origin.masterId); // [CU-14]
  if (replayed.mutes(topic, origin.publisherId)) return; // [CU-15]
  const entry = topics.getOrCreate(topic);
  const { ownDirect, ownSampled } = topics.targetsOf(entry);
  if (ownDirect + ownSampled === 0) return topics.forgetIfUnused(entry);
  const value = { stamp: entry.stamp, masterId: entry.originId ?? context.id };
  const isKept = entry.record === undefined || isNewer(origin, value);
  if (isKept || !origin.isValue) deliver(context, entry, publication, origin, isKept);
}

function deliver(
  { topics, counters, tap, kept }: ForeignContext,
  entry: TopicEntry,
  publication: Publication,
  origin: Origin,
  isKept: boolean,
): void {
  const { valueField, monotonicMs } = publication;
  const { direct, sampled, ownDirect, ownSampled } = topics.targetsOf(entry);
  const record = publication.keepRecord();
  counters.recordsFromMasters++;
  if (isKept) {
    if (entry.isKept) kept.handleReplaced(entry);
    topics.store(entry, record, valueField, publication.nowMs);
    entry.publisherId = origin.publisherId;
    entry.originId = origin.masterId;
    entry.stamp = origin.stamp;
    if (origin.isValue) tap.taker?.takeValue(entry, record);
    else tap.taker?.take(entry, record);
  }
  const isEvent = isEventField(valueField);
  for (let i = 0; i < ownDirect; i++) direct[i]!.deliver(entry, record, isEvent);
  // Samples are taken from the value of the topic.
  for (let i = 0; isKept && i < ownSampled; i++) {
    const sample = sampled[i]!;
    sample.sampler.handleRecord(sample, monotonicMs);
  }
}

/** Deletes a value that its master has deleted. */
export function endForeign(
  topics: TopicTable,
  entry: TopicEntry | undefined,
  masterId: string,
): void {
  if (entry?.record === undefined || entry.originId !== masterId) return;
  topics.dropForeign(entry);
}
