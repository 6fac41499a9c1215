import {
  DATA_FORMATS,
  dataFormatOfField,
  isExtensionTopic,
  isMasterTopic,
  type Component,
} from '@ubii/proto';
import type { TokenBucket } from '@ubii/timing';
import type { ChannelSource } from '@ubii/recording/recorder';
import type { Account } from '../shares/account.ts';
import type { ReadRights } from './rights.ts';

// Topics and who gets their records point at each other: what they know of each other is this one file.

/** The publisher that owns the topic: the first one on a topic without a value [TD-19]. */
export interface TopicOwner {
  readonly id: string;
  readonly ownedTopics: Set<TopicEntry>;
  /** Pays for its topics and for what is retained there [AC-80]. */
  readonly account: Account;
}

/** A publisher on a topic, and what records it. */
export interface TappedSource extends ChannelSource {
  /** Bits of what records it, and what records images of it. */
  readonly targets: number;
  readonly targetsOfImages: number;
  /** Its texts are markers. [RC-24] */
  readonly isOfMarkers: boolean;
  /** Selections have changed since then when it is not the current one. */
  readonly generation: number;
}

/** Everything the master knows of one topic. Plain fields: this is what the record path touches. */
export class TopicEntry {
  readonly topic: string;
  /** A client's record is refused here [TD-16]. */
  readonly isMasters: boolean;
  /** Each record tells of something else: none replaces another [TD-31]. */
  readonly isNews: boolean;
  /** Reaches extension clients only [TD-26]. */
  readonly isExtension: boolean;

  /** The retained record, encoded; undefined while the topic has no value. */
  record: Uint8Array | undefined = undefined;
  /** Field number of the retained record's value. */
  valueField = 0;
  /** Place of the retained record in the order of all records. */
  sequence = 0;
  /** When the retained record came, epoch milliseconds. */
  publishedMs = 0;
  publisherId = '';
  /** Id of the master that the value came from; undefined: it was published here. [CU-10] */
  originId: string | undefined = undefined;
  /** Order of the values of this topic among all masters: the greatest counts. [CU-12] */
  stamp = 0;
  /** The value outlives its publisher, and ends when its time is over [TD-43]. */
  isKept = false;
  /** Sequence of the record that the search for expired values saw here last [TD-47]. */
  seenSequence = 0;
  /** When that record expires, monotonic milliseconds; `undefined` until a sweep computes it. */
  expiresMs: number | undefined = undefined;
  owner: TopicOwner | undefined = undefined;
  /** The account that this topic and its retained record count for [AC-80]. */
  payer: Account | undefined = undefined;
  /** The publisher of the last record that was recorded, as the recorder knows it [RC-50]. */
  recordSource: TappedSource | undefined = undefined;

  records = 0;
  bytes = 0;
  dropped = 0;
  /** Epoch of the statistics in which something of this entry changed last [EX-13]. */
  changedEpoch = 0;

  /** Subscriptions by topic, with their rates in Hz (0: every record). */
  readonly subscribers = new Map<Subscriber, number>();
  /** Patterns that match, found when the topic or the pattern appeared [TD-22]. */
  patterns: SharedPattern[] = [];
  /** Component profiles that select this topic [TD-27]. */
  selections: SharedSelection[] = [];
  /** Subscribers that receive a record; computed again when `areTargetsStale`. */
  targets: Targets | undefined = undefined;
  areTargetsStale = true;

  constructor(topic: string) {
    this.topic = topic;
    this.isMasters = isMasterTopic(topic);
    this.isExtension = isExtensionTopic(topic);
    this.isNews = this.isMasters && !this.isExtension;
  }

  /** The value has no owner here; the next client that publishes becomes its owner. */
  get isAdoptable(): boolean {
    return this.isKept || (this.originId !== undefined && this.owner === undefined);
  }
}

/** Subscription shared by several subscribers: a pattern or a component profile, and its topics. */
export interface SharedSubscription {
  /** Subscribers with their rates in Hz (0: every record). */
  readonly subscribers: Map<Subscriber, number>;
  readonly entries: Set<TopicEntry>;
}

/** [TD-22] */
export interface SharedPattern extends SharedSubscription {
  readonly source: string;
}

/** [TD-27] */
export interface SharedSelection extends SharedSubscription {
  readonly profile: Component;
}

/** A subscriber: a client, a module on the master, or another master for its own subscribers. */
export interface Subscriber {
  readonly clientId: string;
  /** Another master: gets records published here, and none that came from masters. [CU-11] */
  readonly isPeer: boolean;
  /** Gets topics under /ubii/, and retained records for patterns and profiles [TD-24] [TD-26]. */
  readonly isExtension: boolean;
  readonly outbox: Receiver;
  /** Pays for its subscriptions [AC-80]. */
  readonly account: Account;
  /** Undefined: it may receive everything [AC-25]. */
  readRights: ReadRights | undefined;
  /** Undefined: gets every record. */
  readonly sampler: TopicSampler | undefined;
  /** Milliseconds that matching its patterns may take [TD-29]. */
  readonly patternBudget: TokenBucket;
  readonly topics: Set<TopicEntry>;
  readonly patterns: Set<SharedPattern>;
  readonly selections: Set<SharedSelection>;
  /** Ids of its devices that watch everything [DV-3]. */
  readonly watchers: Set<string>;
}

/** Receives the records of one subscriber. */
export interface Receiver {
  /** A record was published, and is in `entry` now. The hot path. */
  deliver(entry: TopicEntry, record: Uint8Array, isEvent: boolean): void;
  /** The retained record, unless a newer one than number `sinceSequence` came by itself. */
  replay(entry: TopicEntry, sinceSequence: number): void;
  /** The value of the topic was deleted. [TD-42] */
  handleGone(entry: TopicEntry): void;
  /** The value has expired: what waits of it is dropped [TD-47]. */
  withdraw(entry: TopicEntry): void;
  /** The subscriber has no subscription to the topic any more. */
  cancelReplay(entry: TopicEntry): void;
}

/** Subscribers that receive a record of a topic, each client once [TD-14]. Other masters come last. */
export interface Targets {
  /** Get every record. */
  readonly direct: readonly Receiver[];
  /** Get the newest one, at most so often [TD-28]. */
  readonly sampled: readonly Sample[];
  /** How many of each are of this master. */
  readonly ownDirect: number;
  readonly ownSampled: number;
}

/** One topic that one client gets at most so often [TD-28]. */
export interface Sample {
  readonly entry: TopicEntry;
  readonly sampler: TopicSampler;
  intervalMs: number;
  /** When the next record may leave, monotonic milliseconds. */
  dueMs: number;
  /** The subscription is gone. */
  cancel(): void;
  /** The client gets every record from now on: what is held back goes first. */
  release(): void;
}

/** The sampled topics of one client. */
export interface TopicSampler {
  /** A new record is in `sample.entry`: delivers it, or holds it back until the interval is over. */
  handleRecord(sample: Sample, nowMs: number): void;
  cancel(sample: Sample): void;
  release(sample: Sample): void;
  /** [TD-47] */
  withdraw(sample: Sample): void;
  /** The value of its topic was deleted. [CU-14] */
  handleGone(sample: Sample): void;
}

const EVENT_FIELDS = new Set(
  Object.values(DATA_FORMATS)
    .filter((info) => info.isEvent)
    .map((info) => info.fieldNumber),
);

/** Whether a record with this value is an event, of which every single one counts, rather than a state [TD-31]. */
export function isEventField(valueField: number): boolean {
  return EVENT_FIELDS.has(valueField);
}

/** Short name of the data format of the retained record; empty when there is none. */
export function dataFormatOf(entry: TopicEntry): string {
  return entry.record === undefined ? '' : (dataFormatOfField(entry.valueField) ?? '');
}
