import {
  dataFormatOfField,
  decode,
  encode,
  messageDescriptor,
  timestampFromMs,
  timestampToMs,
  type TopicDataRecord,
} from '@ubii/proto';
import { readRecordHead } from '@ubii/proto/wire';

import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordingHeader } from '../records/recording-header.ts';
import { FORMATS_WITH_TEXTS, type KnownPeople } from './known-people.ts';
import { KnownTexts, type KnownText } from './known-texts.ts';
import { applyLabel, readyLabel, VALUE_FIELDS, type ReadyLabel } from './labels.ts';
import type { PersonalRules } from './personal-rules.ts';
import type { Pseudonyms } from './pseudonyms.ts';
import { treatEvent } from './treat-events.ts';
import { treatMessage, type Fields } from './treat-message.ts';
import { TreatmentReport, type Place } from './treatment-report.ts';

/**
 * Replaces or drops personal data of a recording. All members are synchronous, and give the same result for the same value.
 * What is not touched is returned as it is.
 */
export interface Treatment {
  /** Returns the topic as it is shared; undefined when the whole topic is dropped. */
  topic(topic: string): string | undefined;
  /** Returns the id of a client as it is shared. The empty id of the master stays. */
  clientId(id: string): string;
  /** Returns the name of a client as it is shared. */
  clientName(name: string): string;
  /** Added to all absolute times, nanoseconds. */
  readonly shiftNs: bigint;
  /** Returns the record as it is shared, its topic included; undefined when it is dropped. */
  record(record: RecordedRecord): RecordedRecord | undefined;
  /** Returns the event as it is shared; undefined when it is dropped. */
  event(event: RecordingEvent): RecordingEvent | undefined;
  /** Says what was found of labelled values so far, as sentences without their ends. [PD-18] */
  report(): readonly string[];
  /** Returns the header as it is shared. */
  header(header: RecordingHeader): RecordingHeader;
}

const RECORD_TYPE = 'ubii.topicData.TopicDataRecord';
/** Topics of a client begin with its id. */
const LEADING_UUID = /^\/([0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12})(?=\/|$)/i;
/** The members of a record that hold its value. */
const VALUE_OF_RECORD = { ...messageDescriptor(RECORD_TYPE), fields: VALUE_FIELDS };
/** In place of a text that a label drops. */
const REMOVED = 'removed';

/**
 * Makes the treatment of one recording.
 *
 * @param people of that recording, by `findPeople`
 * @param pseudonyms has those that were given afterwards, for the key file
 */
export function createTreatment(
  rules: PersonalRules,
  people: KnownPeople,
  pseudonyms: Pseudonyms,
): Treatment {
  return new RuleTreatment(rules, people, pseudonyms);
}

class RuleTreatment implements Treatment {
  readonly #rules: PersonalRules;
  readonly #people: KnownPeople;
  readonly #pseudonyms: Pseudonyms;
  readonly #known = new KnownTexts();
  readonly #labels: readonly ReadyLabel[];
  readonly #labelsOfTopic = new Map<string, readonly ReadyLabel[]>();
  readonly #topics = new Map<string, string | undefined>();
  readonly #shiftMs: number;
  readonly #report: TreatmentReport;
  /** Where the texts stand that are treated now. */
  #place: Place = 'header';
  /** As message treatments take them. */
  readonly #parts;

  constructor(rules: PersonalRules, people: KnownPeople, pseudonyms: Pseudonyms) {
    this.#rules = rules;
    this.#people = people;
    this.#pseudonyms = pseudonyms;
    this.#labels = rules.labels.map(readyLabel);
    this.#shiftMs = rules.time === 'shift' ? pseudonyms.key.shiftMs : 0;
    this.#report = new TreatmentReport(people.labelled);
    const isReplaced = rules.clients === 'pseudonym';
    const note = (known: KnownText): void => this.#note(known, this.#place);
    const text = (text: string): string => this.#known.replaceIn(text, note);
    const name = (one: string, prefix: string): string =>
      isReplaced ? pseudonyms.of(one, prefix) : text(one);
    if (isReplaced) {
      for (const id of people.clientIds) this.#known.add(id, name(id, 'client'));
      for (const one of people.clientNames) this.#known.add(one, name(one, 'client'));
      for (const one of people.deviceNames) this.#known.add(one, name(one, 'device'));
    }
    for (const [one, prefix] of people.labelled.texts) {
      const replacement = prefix === undefined ? REMOVED : pseudonyms.of(one, prefix);
      this.#known.add(one, replacement, { isLabelled: true });
    }
    this.#parts = {
      name,
      text,
      clientId: (id: string) => name(id, 'client'),
      code: (code: string) => this.#code(code),
      timeMs: (timeMs: number) => timeMs + this.#shiftMs,
      topic: (topic: string) => this.topic(topic),
      shiftNs: this.shiftNs,
    };
  }

  topic(topic: string): string | undefined {
    if (this.#topics.has(topic)) return this.#topics.get(topic);
    // Messages of other programs cannot be searched.
    const isDropped =
      this.#people.foreignTopics.has(topic) ||
      this.#labelsOf(topic).some(({ dropsTopic }) => dropsTopic);
    const shared = isDropped ? undefined : this.#replacedTopic(topic);
    this.#topics.set(topic, shared);
    return shared;
  }

  get shiftNs(): bigint {
    return BigInt(this.#shiftMs) * 1_000_000n;
  }

  clientId(id: string): string {
    return this.#parts.clientId(id);
  }

  clientName(name: string): string {
    return this.#parts.name(name, 'client');
  }

  record(record: RecordedRecord): RecordedRecord | undefined {
    const topic = this.topic(record.topic);
    if (topic === undefined) return undefined;
    this.#place = { topic };
    const bytes = this.#bytes(record);
    if (bytes === undefined) return undefined;
    const clientId = this.clientId(record.clientId);
    const logTimeNs = record.logTimeNs + this.shiftNs;
    const publishTimeNs = record.publishTimeNs + this.shiftNs;
    return { topic, clientId, record: bytes, logTimeNs, publishTimeNs };
  }

  event(event: Parameters<Treatment['event']>[0]) {
    this.#place = event.kind;
    return treatEvent(event, this.#rules, this.#parts);
  }

  report(): readonly string[] {
    return this.#report.sentences();
  }

  header(header: RecordingHeader): RecordingHeader {
    this.#place = 'header';
    const { kind, version, masterName } = header;
    const isKept = this.#rules.notes === 'keep';
    const { name, text } = this.#parts;
    return {
      kind,
      version: text(version),
      masterName: name(masterName, 'master'),
      name: isKept ? text(header.name) : 'Shared recording',
      notes: isKept ? text(header.notes) : '',
      // Names clients, invitations and devices.
      selection: '{}',
    };
  }

  /** The record with what rules change; as it is when they change nothing, undefined when it is dropped. */
  #bytes({ topic, record }: RecordedRecord): Uint8Array | undefined {
    const labels = this.#labelsOf(topic);
    try {
      const head = readRecordHead(record);
      const inner = this.topic(head.topic);
      if (inner === undefined) return undefined;
      const clientId = this.clientId(head.clientId);
      const isOuterChanged =
        inner !== head.topic || clientId !== head.clientId || this.#shiftMs !== 0;
      const format = dataFormatOfField(head.valueField) ?? '';
      if (!isOuterChanged && labels.length === 0 && !FORMATS_WITH_TEXTS.has(format)) return record;
      const message = decode(RECORD_TYPE, record);
      const isValueChanged = this.#treatValue(message, labels);
      if (isValueChanged === undefined) return undefined;
      if (!isOuterChanged && !isValueChanged) return record;
      const timestamp = this.#shifted(message.timestamp);
      return encode(RECORD_TYPE, { ...message, topic: inner, clientId, timestamp });
    } catch {
      // What cannot be read cannot be searched.
      return undefined;
    }
  }

  /** @returns whether something changed; undefined when the record is dropped */
  #treatValue(message: TopicDataRecord, labels: readonly ReadyLabel[]): boolean | undefined {
    const fields = message as unknown as Fields;
    for (const label of labels) {
      const isKept = applyLabel(fields, label, (text, prefix) => this.#pseudonyms.of(text, prefix));
      if (!isKept) return undefined;
    }
    return treatMessage(VALUE_OF_RECORD, fields, this.#parts) || labels.length > 0;
  }

  #shifted(timestamp: TopicDataRecord['timestamp']): TopicDataRecord['timestamp'] {
    const timeMs = timestampToMs(timestamp);
    if (timeMs === undefined || this.#shiftMs === 0) return timestamp;
    return timestampFromMs(timeMs + this.#shiftMs);
  }

  #labelsOf(topic: string): readonly ReadyLabel[] {
    const known = this.#labelsOfTopic.get(topic);
    if (known !== undefined) return known;
    const labels = this.#labels.filter(({ matches }) => matches(topic));
    this.#labelsOfTopic.set(topic, labels);
    return labels;
  }

  #replacedTopic(topic: string): string {
    const id = this.#rules.clients === 'keep' ? undefined : LEADING_UUID.exec(topic)?.[1];
    if (id !== undefined) this.#known.add(id, this.clientId(id));
    return this.#known.replaceInTopic(topic, (known) => this.#note(known, 'topic name'));
  }

  #note({ normal, isLabelled }: KnownText, place: Place): void {
    if (isLabelled) this.#report.note(normal, place);
  }

  /** Code in which a text was replaced might not run any more, and would not say so. [PD-12] */
  #code(code: string): string {
    if (!this.#known.hasLabelled(code)) return code;
    this.#report.noteCode(code);
    return '';
  }
}
