import { DATA_FORMATS, dataFormatOfField, isExtensionTopic, isMasterTopic } from '@ubii/proto';
import type { Account } from '../shares/account.ts';
import type { ComponentSelection } from './component-selection.ts';
import type { Pattern } from './pattern.ts';
import type { Subscriber } from './subscriber.ts';
import type { Targets } from './targets.ts';

/** The publisher that owns the topic: the first one on a topic without a value [TD-19]. */
export interface TopicOwner {
  readonly id: string;
  readonly ownedTopics: Set<TopicEntry>;
  /** Pays for its topics and for what is retained there [AC-80]. */
  readonly account: Account;
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
  /** The value outlives its publisher, and ends when its time is over [TD-43]. */
  isKept = false;
  /** Sequence of the record that the search for expired values saw here last [TD-47]. */
  seenSequence = 0;
  /** When that record expires, monotonic milliseconds; `undefined` until a sweep computes it. */
  expiresMs: number | undefined = undefined;
  owner: TopicOwner | undefined = undefined;
  /** The account that this topic and its retained record count for [AC-80]. */
  payer: Account | undefined = undefined;

  records = 0;
  bytes = 0;
  dropped = 0;
  /** Epoch of the statistics in which something of this entry changed last [EX-13]. */
  changedEpoch = 0;

  /** Subscriptions by topic, with their rates in Hz (0: every record). */
  readonly subscribers = new Map<Subscriber, number>();
  /** Patterns that match, found when the topic or the pattern appeared [TD-22]. */
  patterns: Pattern[] = [];
  /** Component profiles that select this topic [TD-27]. */
  selections: ComponentSelection[] = [];
  /** Who gets a record; computed anew when `areTargetsStale`. */
  targets: Targets | undefined = undefined;
  areTargetsStale = true;

  constructor(topic: string) {
    this.topic = topic;
    this.isMasters = isMasterTopic(topic);
    this.isExtension = isExtensionTopic(topic);
    this.isNews = this.isMasters && !this.isExtension;
  }
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
