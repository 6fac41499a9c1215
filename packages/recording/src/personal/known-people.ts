import { decodeRecord, type EmptyRecord, type PersonalLabel, type TopicRecord } from '@ubii/proto';
import type { EventsReader } from '../reading/recording-reader.ts';
import { findLabelledTexts, type LabelledTexts } from './labelled-texts.ts';

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

/** Data formats that tell names. */
const NAMING = new Set(['client', 'device', 'deviceList']);

/** Finds what a recording tells of people. Reads its events, and records of clients, of devices and of labelled topics. */
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
  const telling = topics.filter(({ isRaw, format }) => !isRaw && NAMING.has(format));
  for await (const { record } of reader.records({ topics: telling.map(({ topic }) => topic) })) {
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
