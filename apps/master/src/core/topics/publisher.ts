import { isMasterTopic } from '@ubii/proto';
import { changeRecordHead } from '@ubii/proto/wire';
import type { Accounts } from '../shares/accounts.ts';
import { RESOURCE } from '../shares/resources.ts';
import type { Limits } from '../limits/index.ts';
import type { Counters } from '../counters/counters.ts';
import { isOwnFarewell } from './farewell.ts';
import type { KeptValues } from './kept-values.ts';
import { Publication, type PublishingClient } from './publication.ts';
import type { RecordTap } from './record-tap.ts';
import { REFUSALS, type Refusal } from './refusals.ts';
import type { LiveRule, ReplayedTopics } from './replayed-topics.ts';
import { isEventField } from './topic-entry.ts';
import { topicFault } from './topic-names.ts';
import { nextStamp } from './stamps.ts';
import type { TopicTable } from './topic-table.ts';

/** Dependencies of publishing. */
export interface PublishContext {
  readonly topics: TopicTable;
  readonly limits: Limits;
  readonly accounts: Accounts;
  readonly counters: Counters;
  readonly kept: KeptValues;
  readonly tap: RecordTap;
  readonly replayed: ReplayedTopics;
}

/**
 * Publishes a record, or says why not. The hot path: its cost is that of the topic's subscribers.
 * Plain calls rather than a list of steps, because those the compiler can inline.
 */
export function publish(context: PublishContext, publication: Publication): Refusal | undefined {
  findTopic(context, publication);
  const isClients = publication.client !== undefined;
  const refusal = isClients ? checkClients(context, publication) : undefined;
  if (refusal !== undefined) return refusal;
  if (context.replayed.isActive && isClients) {
    const rule = context.replayed.ruleFor(publication);
    if (rule !== undefined) return publishLive(context, publication, rule);
  }
  accept(context, publication);
  return undefined;
}

function accept(context: PublishContext, publication: Publication): void {
  createTopic(context, publication);
  if (publication.client !== undefined) {
    takeOwnership(context, publication);
    countIn(context, publication);
  }
  storeAndDeliver(context, publication);
}

/** A live record on a topic that is replayed: refuses it, or publishes it elsewhere. [RP-20] [RP-21] */
function publishLive(
  context: PublishContext,
  publication: Publication,
  rule: LiveRule,
): Refusal | undefined {
  const { livePrefix } = rule;
  context.replayed.keepLive(publication);
  if (livePrefix === undefined) return REFUSALS.replayed;
  const { client, frame, start, end } = publication;
  const moved = new Publication();
  moved.client = client;
  moved.topic = livePrefix + publication.topic;
  moved.frame = changeRecordHead(frame.subarray(start, end), { topic: moved.topic });
  moved.end = moved.frame.byteLength;
  moved.valueField = publication.valueField;
  moved.nowMs = publication.nowMs;
  moved.monotonicMs = publication.monotonicMs;
  findTopic(context, moved);
  if (!rule.mayMove(moved)) return REFUSALS.replayed;
  const refusal =
    checkTopic(context, moved) ??
    checkTopicCount(context, moved) ??
    checkRetainedBytes(context, moved);
  if (refusal === undefined) {
    accept(context, moved);
    rule.onMoved(moved);
  } else publication.shortage = moved.shortage;
  return refusal;
}

/** Returns the first reason to refuse a record of a client, in this order. */
function checkClients(context: PublishContext, publication: Publication): Refusal | undefined {
  return (
    checkRate(publication) ??
    checkTopic(context, publication) ??
    checkRights(publication) ??
    checkTopicCount(context, publication) ??
    checkRetainedBytes(context, publication)
  );
}

function checkRate(publication: Publication): Refusal | undefined {
  const client = publication.client!;
  return client.recordBudget.take(1, publication.monotonicMs) ? undefined : tooManyRecords(client);
}

/** [EX-32] */
function tooManyRecords({ throttle }: PublishingClient): Refusal {
  if (throttle === undefined) return REFUSALS.tooManyRecords;
  throttle.dropped++;
  return REFUSALS.throttled;
}

function findTopic({ topics }: PublishContext, publication: Publication): void {
  publication.entry = topics.get(publication.topic);
}

/** Existing topics were checked when they were created. [TD-13] [TD-16] */
function checkTopic({ limits }: PublishContext, publication: Publication): Refusal | undefined {
  const { entry, topic } = publication;
  if (entry !== undefined) return entry.isMasters ? REFUSALS.mastersTopic : undefined;
  switch (topicFault(topic, limits.topicBytes)) {
    case 'is empty':
      return REFUSALS.noTopic;
    case 'is too long':
      return REFUSALS.longTopic;
    case 'contains a control character':
      return REFUSALS.controlCharacter;
    case undefined:
      return isMasterTopic(topic) ? REFUSALS.mastersTopic : undefined;
  }
}

/** [AC-24] */
function checkRights(publication: Publication): Refusal | undefined {
  const { publishRights } = publication.client!;
  if (publishRights === undefined || publishRights.mayPublish(publication.topic)) return undefined;
  const isFarewell = publishRights.maySayFarewell && isOwnFarewell(publication);
  return isFarewell ? undefined : REFUSALS.notYours;
}

/** [AC-80] */
function checkRetainedBytes(
  context: PublishContext,
  publication: Publication,
): Refusal | undefined {
  const { entry, client } = publication;
  if (entry?.isAdoptable === true) return checkAdoption(context, publication);
  const growth = publication.byteLength - (entry?.record?.byteLength ?? 0);
  if (growth <= 0) return undefined;
  // A record on a topic of another client is charged to the owner of the topic.
  const account = entry?.owner?.account ?? client!.account;
  const resource = RESOURCE.retainedBytes;
  if (account.shortage(resource, growth) === undefined) return undefined;
  // Kept values give their room back [TD-44].
  publication.shortage = context.accounts.shortage(account, resource, growth);
  if (publication.shortage !== undefined) return REFUSALS.noRoom;
  findTopic(context, publication);
  return undefined;
}

/** The client becomes the owner of a topic whose value was kept, and pays for all of its record. */
function checkAdoption(context: PublishContext, publication: Publication): Refusal | undefined {
  const { client, byteLength } = publication;
  const resource = RESOURCE.retainedBytes;
  publication.shortage = context.accounts.shortage(client!.account, resource, byteLength);
  if (publication.shortage !== undefined) return REFUSALS.noRoom;
  // The value itself may have made room.
  findTopic(context, publication);
  return undefined;
}

/** A topic without value gets one, and with it an owner, who pays for it: there may be too many [AC-80]. */
function checkTopicCount(context: PublishContext, publication: Publication): Refusal | undefined {
  const { entry, client } = publication;
  if (entry?.record !== undefined && !entry.isAdoptable) return undefined;
  const { account } = client!;
  const resource = RESOURCE.topics;
  if (account.shortage(resource, 1, entry?.payer) === undefined) return undefined;
  publication.shortage = context.accounts.shortage(account, resource, 1, entry?.payer);
  if (publication.shortage !== undefined) return REFUSALS.noRoom;
  // The evicted client may have been the last subscriber of this topic.
  findTopic(context, publication);
  return undefined;
}

function createTopic({ topics }: PublishContext, publication: Publication): void {
  publication.entry ??= topics.getOrCreate(publication.topic);
}

function takeOwnership({ topics, kept }: PublishContext, { entry, client }: Publication): void {
  if (entry!.record === undefined) topics.own(entry!, client!); // [TD-19]
  else if (entry!.isAdoptable) kept.handleAdopted(entry!, client!);
}

function countIn({ counters }: PublishContext, publication: Publication): void {
  const { traffic } = publication.client!;
  const { byteLength } = publication;
  counters.recordsIn++;
  counters.bytesIn += byteLength;
  traffic.recordsIn++;
  traffic.bytesIn += byteLength;
}

function storeAndDeliver(context: PublishContext, publication: Publication): void {
  const { valueField, monotonicMs } = publication;
  const entry = publication.entry!;
  // Before the value changes: what a change of subscriptions releases is the value before.
  const { direct, sampled } = context.topics.targetsOf(entry);
  const record = publication.keepRecord(); // [TD-11]
  context.topics.store(entry, record, valueField, publication.nowMs);
  const { client } = publication;
  entry.publisherId = client?.id ?? '';
  entry.originId = undefined;
  entry.stamp = nextStamp(entry.stamp, publication.nowMs);
  context.tap.taker?.take(entry, record); // [RC-50]
  if (client !== undefined) {
    const { traffic } = client; // [EX-27]
    const receivers = direct.length + sampled.length;
    traffic.recordsCaused += receivers;
    traffic.bytesCaused += receivers * record.byteLength;
  }
  const isEvent = entry.isNews || isEventField(valueField);
  for (let i = 0; i < direct.length; i++) direct[i]!.deliver(entry, record, isEvent); // [TD-14]
  for (let i = 0; i < sampled.length; i++) {
    const sample = sampled[i]!;
    sample.sampler.handleRecord(sample, monotonicMs); // [TD-28]
  }
}
