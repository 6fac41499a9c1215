import {
  decode,
  decodeRecord,
  type PersonalLabel,
  type EmptyRecord,
  type TopicRecord,
} from '@ubii/proto';

import type { RecordsReader, EventsReader } from '../reading/recording-reader.ts';
import { describeRecord, type RecordedRecord } from '../records/recorded-record.ts';
import { parseJsonText, textsOfJson } from './json-texts.ts';
import { isTelling } from './known-texts.ts';
import { eachLabelledText, readyLabel, VALUE_FIELDS } from './labels.ts';
import { normalOf } from './normal-form.ts';
import { hasTexts, isMessage, type Fields } from './treat-message.ts';

const RECORD_TYPE = 'ubii.topicData.TopicDataRecord';
const MAX_TEXTS = 50_000;
const MAX_CHARACTERS = 4_000_000;

/** Data formats without texts need no decoding. */
export const FORMATS_WITH_TEXTS: ReadonlySet<string> = new Set(
  VALUE_FIELDS.filter(({ type }) => type === 'string' || (isMessage(type) && hasTexts(type))).map(
    ({ jsonName }) => jsonName,
  ),
);

/** Texts that labels name in a recording, to be searched for elsewhere in it. [PD-16] */
export interface LabelledTexts {
  /** With the prefix of their pseudonyms; with undefined where a label drops them. */
  readonly texts: ReadonlyMap<string, string | undefined>;
  /** How many are not among them because they do not tell enough. [PD-18] */
  readonly short: number;
  /** There are more texts than can be searched for. [PD-18] */
  readonly isIncomplete: boolean;
}

/** Finds the texts that labels name. Reads the records of their topics. */
async function findLabelledTexts(
  reader: RecordsReader,
  labels: readonly PersonalLabel[],
): Promise<LabelledTexts> {
  const ready = labels.map(readyLabel);
  const own = reader.summary.topics.filter(({ isRaw }) => !isRaw);
  const byTopic = new Map(
    own.map(({ topic }) => [topic, ready.filter(({ matches }) => matches(topic))]),
  );
  const topics = [...byTopic.keys()].filter((topic) => byTopic.get(topic)!.length > 0);
  const found = new FoundTexts();
  if (topics.length === 0) return found;
  for await (const record of reader.records({ topics })) {
    const fields = fieldsOf(record);
    if (fields === undefined) continue;
    for (const label of byTopic.get(record.topic)!) {
      eachLabelledText(fields, label, (text, prefix) => found.add(text, prefix));
    }
  }
  return found;
}

class FoundTexts implements LabelledTexts {
  readonly texts = new Map<string, string | undefined>();
  readonly #short = new Set<string>();
  #characters = 0;
  isIncomplete = false;

  get short(): number {
    return this.#short.size;
  }

  /** Adds a text; of a text that is JSON, those in it. */
  add(text: string, prefix: string | undefined): void {
    if (this.texts.has(text)) return;
    const json = parseJsonText(text);
    if (json === undefined) this.#add(text, prefix);
    else for (const inner of textsOfJson(json)) this.add(inner, prefix);
  }

  #add(text: string, prefix: string | undefined): void {
    const normal = normalOf(text);
    if (normal === '') return;
    if (!isTelling(normal)) {
      if (this.#short.size < MAX_TEXTS) this.#short.add(normal);
      return;
    }
    const isFull = this.texts.size >= MAX_TEXTS;
    if (isFull || this.#characters + text.length > MAX_CHARACTERS) this.isIncomplete = true;
    else {
      this.texts.set(text, prefix);
      this.#characters += text.length;
    }
  }
}

/** Undefined without texts, and when the record cannot be read: it is dropped then. */
function fieldsOf({ record }: RecordedRecord): Fields | undefined {
  const { format } = describeRecord(record);
  if (format === undefined || !FORMATS_WITH_TEXTS.has(format)) return undefined;
  try {
    return decode(RECORD_TYPE, record) as unknown as Fields;
  } catch {
    return undefined;
  }
}

/** Names, ids and labelled texts in a recording, and what of it cannot be searched for them. */
export interface KnownPeople {
  readonly clientIds: ReadonlySet<string>;
  readonly clientNames: ReadonlySet<string>;
  readonly deviceNames: ReadonlySet<string>;
  /** What labels name. */
  readonly labelled: LabelledTexts;
  /** Topics with messages of other programs. */
  readonly foreignTopics: ReadonlySet<string>;
}

/** Data formats with names. */
const NAMING = new Set(['client', 'device', 'deviceList']);

/** Finds names and ids of people in a recording. Reads its events, and records of clients, of devices and of labelled topics. */
export async function findPeople(
  reader: EventsReader,
  labels: readonly PersonalLabel[],
): Promise<KnownPeople> {
  const ids = new Set<string>();
  const names = new Set<string>();
  const deviceNames = new Set<string>();
  const { topics } = reader.summary;
  for (const { clientId, clientName } of topics) {
    ids.add(clientId);
    names.add(clientName);
  }
  for (const { kind, value } of await reader.events()) {
    if (kind === 'client') {
      ids.add(value.id);
      names.add(value.name);
    } else if (kind === 'marker') {
      ids.add(value.authorId);
      names.add(value.author);
    } else if (kind === 'device') {
      ids.add(value.clientId);
      deviceNames.add(value.name);
    } else if (kind === 'clock') ids.add(value.clientId);
  }
  const naming = topics.filter(({ isRaw, format }) => !isRaw && NAMING.has(format));
  for await (const { record } of reader.records({ topics: naming.map(({ topic }) => topic) })) {
    const decoded = decodeSafely(record);
    if (decoded?.format === 'client') {
      ids.add(decoded.value.id);
      names.add(decoded.value.name);
    } else if (decoded?.format === 'device') deviceNames.add(decoded.value.name);
    else if (decoded?.format === 'deviceList') {
      for (const { name } of decoded.value.elements) deviceNames.add(name);
    }
  }
  const foreignTopics = new Set(topics.filter(({ isRaw }) => isRaw).map(({ topic }) => topic));
  const labelled = await findLabelledTexts(reader, labels);
  return { clientIds: ids, clientNames: names, deviceNames, labelled, foreignTopics };
}

function decodeSafely(record: Uint8Array): TopicRecord | EmptyRecord | undefined {
  try {
    return decodeRecord(record);
  } catch {
    return undefined;
  }
}
