import {
  decodeRecord,
  encodeRecord,
  PersonalTreatment,
  toJson,
  type RecordInit,
} from '@ubii/proto';
import { expect, it } from 'vitest';
import { xdfOf } from '../export/xdf/xdf.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordingHeader } from '../records/recording-header.ts';
import { contentOf } from '../testing/content-of.ts';
import { MemoryFile } from '../testing/memory-file.ts';
import { recordedDevice } from '../testing/recorded-device.ts';
import { SAMPLE_HEADER, SAMPLE_START_NS } from '../testing/sample-records.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';
import { createTreatment } from './create-treatment.ts';
import { findPeople } from './known-people.ts';
import { SHARING_RULES, type PersonalRules } from './personal-rules.ts';
import { createPseudonymKey, Pseudonyms } from './pseudonyms.ts';
import { TreatedReader, treatRecording } from './treated-reader.ts';

/** The labelled value. */
const VALUE = 'José Müller';
const LABELLED = '/person/name';
const START_MS = Number(SAMPLE_START_NS / 1_000_000n);

const SPELLINGS = {
  'as it is': VALUE,
  'upper case': VALUE.toUpperCase(),
  NFD: VALUE.normalize('NFD'),
  'two spaces': 'José  Müller',
  'other white space': 'José\u00a0\n\tMüller',
  underscore: 'José_Müller',
  'hyphen and lower case': 'josé-müller',
  'without accents': 'Jose Muller',
  'full width': 'Ｊｏｓé Ｍüller',
  'soft hyphens and joiners': 'Jo\u00adsé\u200b Mü\u2060ller',
  'JSON escapes': 'Jos\\u00e9 M\\u00FCller',
  'JSON escapes of NFD': 'Jose\\u0301\\u0020Mu\\u0308ller',
  'other escapes': 'Jos\\xe9\\tM\\u{fc}ller',
  'URL encoding': 'Jos%C3%A9%20M%c3%bcller',
  'URL encoding of a form': 'Jos%C3%A9+M%C3%BCller',
  'URL encoding twice': 'Jos%25C3%25A9%2520M%25C3%25BCller',
  'URL encoding as Latin-1': 'Jos%E9%20M%FCller',
  entities: 'Jos&#233;&nbsp;M&#xFC;ller',
} as const;

interface Content {
  readonly header?: Partial<RecordingHeader>;
  readonly events?: readonly RecordingEvent[];
  readonly records?: readonly RecordInit[];
}

const event = (kind: string, value: object): Content => ({
  events: [{ kind, timeNs: SAMPLE_START_NS, value } as unknown as RecordingEvent],
});
const text = (value: string, topic = '/chat'): Content => ({
  records: [{ topic, format: 'string', value }],
});
const marker = (more: object): Content =>
  event('marker', {
    id: 'm',
    timeMs: 1e12,
    text: '',
    author: '',
    authorId: '',
    kind: 'key',
    ...more,
  });
const client = (more: object): Content =>
  event('client', { id: 'plain-id', name: 'n', tags: [], state: 'active', ...more });
const session = (more: object): Content =>
  event('session', {
    id: 's',
    name: 'n',
    state: 'running',
    session: JSON.stringify(toJson('ubii.sessions.Session', more)),
  });
const device = (component: object, more: object = {}): Content =>
  event('device', recordedDevice('d', 'plain-id', [{ topic: '/a', ...component }], more));
const module = (more: object): Content => session({ processingModules: [{ name: 'm', ...more }] });

/** Where a value can stand beside the member that the label names. */
const PLACES: Readonly<Record<string, (secret: string) => Content>> = {
  'another topic': (secret) => text(secret),
  'a sentence': (secret) => text(`Today ${secret}, again (${secret}).`),
  'a member of JSON': (secret) => text(JSON.stringify({ a: [{ who: secret }], n: 1.5 })),
  'a key of JSON': (secret) => text(JSON.stringify({ [secret]: true })),
  'JSON in JSON': (secret) => text(JSON.stringify({ a: JSON.stringify([secret]) })),
  'JSON in a sentence': (secret) => text(`log: {"who":"${secret}"}`),
  'an address of a page': (secret) => text(`https://lab.example/?who=${secret}&n=1`),
  'a list': (secret) => ({
    records: [{ topic: '/list', format: 'stringList', value: { elements: ['a', secret] } }],
  }),
  'a member of an object': (secret) => ({
    records: [
      { topic: '/o', format: 'object2DList', value: { elements: [{ userDataJson: secret }] } },
    ],
  }),
  'the name of a topic': (secret) => ({
    records: [{ topic: `/lab/${secret}/a`, format: 'double', value: 1 }],
  }),
  'the id of a client': (secret) => client({ id: secret }),
  'the name of a client': (secret) => client({ name: `Phone of ${secret}` }),
  'the tag of a client': (secret) => client({ tags: ['a', `of ${secret}`] }),
  'the state of a client': (secret) => client({ state: secret }),
  'the name of a device': (secret) => device({}, { name: secret }),
  'the tag of a device': (secret) => device({}, { tags: [secret] }),
  'the name of a component': (secret) => device({ name: secret }),
  'the topic of a component': (secret) => device({ topic: `/${secret}/a` }),
  'the tag of a component': (secret) => device({ tags: [secret] }),
  'the format of a component': (secret) => device({ format: secret }),
  'the text of a marker': (secret) => marker({ text: `${secret} begins` }),
  'the author of a marker': (secret) => marker({ author: secret }),
  'the kind of a marker': (secret) => marker({ kind: secret }),
  'the id of a session': (secret) =>
    event('session', { id: secret, name: 'n', state: 'running', session: '{}' }),
  'the name of a session': (secret) =>
    event('session', { id: 's', name: secret, state: secret, session: '{}' }),
  'the description of a session': (secret) => session({ description: `Of ${secret}.` }),
  'the tag of a session': (secret) => session({ tags: [secret] }),
  'an input of a mapping': (secret) =>
    session({ ioMappings: [{ inputMappings: [{ inputName: secret, topic: `/${secret}` }] }] }),
  'the name of a module': (secret) => module({ name: secret }),
  'the code of a module': (secret) =>
    module({ onProcessingStringified: `() => '${secret}'`, languages: [] }),
  'the reason of a gap': (secret) =>
    event('gap', { fromMs: START_MS, untilMs: START_MS, records: 1, reason: `${secret} left` }),
  'the name of the recording': (secret) => ({ header: { name: secret } }),
  'notes on the recording': (secret) => ({ header: { notes: `Of ${secret}.` } }),
  'the selection of the recording': (secret) => ({ header: { selection: `["${secret}"]` } }),
  'the name of the master': (secret) => ({ header: { masterName: secret } }),
  'the version of the program': (secret) => ({ header: { version: secret } }),
};

async function fileOf({ header, events = [], records = [] }: Content): Promise<MemoryFile> {
  const file = new MemoryFile();
  const writer = await RecordingWriter.create(file, { ...SAMPLE_HEADER, ...header });
  for (const each of events) writer.addEvent(each);
  const labelled: RecordInit = { topic: LABELLED, format: 'string', value: VALUE };
  for (const record of [labelled, { topic: '/n', format: 'double', value: 1 }, ...records]) {
    const times = { logTimeNs: SAMPLE_START_NS, publishTimeNs: SAMPLE_START_NS };
    const bytes = encodeRecord(record as RecordInit);
    await writer.addRecord({ topic: record.topic, clientId: 'plain-id', record: bytes, ...times });
  }
  await writer.end();
  return file;
}

function rulesOf(treatment: PersonalTreatment, more: Partial<PersonalRules> = {}): PersonalRules {
  const label = { id: '', topicPattern: LABELLED, fieldPath: 'string', step: 0, note: '' };
  return { ...SHARING_RULES, notes: 'keep', labels: [{ ...label, treatment }], ...more };
}

async function treatmentFor(reader: RecordingReader, rules: PersonalRules) {
  const pseudonyms = new Pseudonyms(createPseudonymKey((bytes) => bytes.fill(3)));
  return createTreatment(rules, await findPeople(reader, rules.labels), pseudonyms);
}

/** All texts of the shared file, and of its export as XDF. */
async function sharedTexts(content: Content, rules: PersonalRules): Promise<string> {
  const reader = await RecordingReader.open(await fileOf(content));
  const treatment = await treatmentFor(reader, rules);
  const file = new MemoryFile();
  await treatRecording(reader, file, treatment);
  const parts = [(await contentOf(file)).toString('utf8')];
  const shared = new TreatedReader(reader, treatment);
  for await (const part of xdfOf(shared)) parts.push(Buffer.from(part).toString('utf8'));
  return parts.join('\n');
}

/** As it can be written in JSON, once and twice, and in XML. */
function writtenForms(secret: string): string[] {
  const once = JSON.stringify(secret).slice(1, -1);
  return [secret, once, JSON.stringify(once).slice(1, -1), secret.replaceAll('&', '&amp;')];
}

/** The spellings of which something stands in a text. */
function foundIn(content: string): string[] {
  return Object.entries(SPELLINGS).flatMap(([spelling, secret]) =>
    writtenForms(secret).some((form) => content.includes(form)) ? [spelling] : [],
  );
}

/** A place with all spellings, one after the other; in texts of the header, one beside the other. */
function contentWith(place: (secret: string) => Content): Content {
  const all = Object.values(SPELLINGS).map(place);
  const header: Record<string, string> = {};
  for (const each of all) {
    for (const [member, secret] of Object.entries(each.header ?? {}))
      header[member] = `${header[member] ?? ''}${secret} / `;
  }
  return {
    header,
    events: all.flatMap(({ events = [] }) => events),
    records: all.flatMap(({ records = [] }) => records),
  };
}

it.each(Object.entries(PLACES))(
  '[PD-16] [PD-17] a labelled value is not in %s',
  async (_, place) => {
    const content = contentWith(place);
    const before = (await contentOf(await fileOf(content))).toString('utf8');
    expect(foundIn(before)).toEqual(Object.keys(SPELLINGS));
    const pseudonym = rulesOf(PersonalTreatment.PERSONAL_TREATMENT_PSEUDONYM);
    expect(foundIn(await sharedTexts(content, pseudonym))).toEqual([]);
    const drop = rulesOf(PersonalTreatment.PERSONAL_TREATMENT_DROP, { clients: 'keep' });
    expect(foundIn(await sharedTexts(content, drop))).toEqual([]);
  },
);

it('[PD-12] [PD-18] code in which a labelled value stands is left out, and the report says so', async () => {
  const codes = [`() => 'of ${VALUE}'`, `() => 'of a Müller'`];
  const modules = codes.map((onProcessingStringified) => ({ name: 'm', onProcessingStringified }));
  const reader = await RecordingReader.open(await fileOf(session({ processingModules: modules })));
  const rules = rulesOf(PersonalTreatment.PERSONAL_TREATMENT_DROP);
  const treatment = await treatmentFor(reader, rules);
  const [event] = await new TreatedReader(reader, treatment).events();
  const { session: json } = event!.value as { session: string };
  const { processingModules } = JSON.parse(json) as { processingModules: object[] };
  expect(processingModules).toMatchObject([
    { name: 'm', onProcessingStringified: '' },
    { name: 'm', onProcessingStringified: codes[1] },
  ]);
  expect(treatment.report()).toEqual([
    'Left out: the code of 1 function of modules, because a labelled value stands in it',
  ]);
});

it('[PD-16] [PD-18] texts in labelled JSON are searched for, answers and keys are not', async () => {
  const answers = { who: 'Ada Lovelace', mood: '4', initials: 'AL', score: 80333 };
  const records: RecordInit[] = [
    { topic: '/form/a', format: 'string', value: JSON.stringify(answers) },
    { topic: '/other', format: 'string', value: 'who is AL? Ada Lovelace.' },
    { topic: '/mood', format: 'string', value: '4' },
    { topic: '/score', format: 'string', value: '80333' },
  ];
  const reader = await RecordingReader.open(await fileOf({ records }));
  const { labels } = rulesOf(PersonalTreatment.PERSONAL_TREATMENT_DROP);
  const rules = { ...SHARING_RULES, labels: [{ ...labels[0]!, topicPattern: '/form/*' }] };
  const treatment = await treatmentFor(reader, rules);
  const values = [];
  for await (const { record } of new TreatedReader(reader, treatment).records())
    values.push(decodeRecord(record).value);
  expect(values.slice(2)).toEqual(['who is AL? removed.', '4', '80333']);
  expect(treatment.report()).toEqual([
    'Replaced elsewhere: 1 labelled value, in 1 topic',
    'Not searched for elsewhere: 2 labelled values of fewer than 3 characters, or of numbers with fewer than 5 digits',
  ]);
});
