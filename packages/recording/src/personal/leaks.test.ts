import {
  encode,
  encodeRecord,
  Image2DDataFormat,
  PersonalTreatment,
  toJson,
  type RecordInit,
} from '@ubii/proto';
import { expect, it } from 'vitest';
import { SNAPSHOT_NAME } from '../mcap/file-index.ts';
import { openFile } from '../mcap/open-file.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import { contentOf } from '../testing/content-of.ts';
import { recordedDevice } from '../testing/recorded-device.ts';
import { MemoryFile } from '../testing/memory-file.ts';
import { SAMPLE_HEADER, SAMPLE_START_NS } from '../testing/sample-records.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';
import { createTreatment } from './create-treatment.ts';
import { findPeople } from './known-people.ts';
import { SHARING_RULES } from './personal-rules.ts';
import { createPseudonymKey, Pseudonyms } from './pseudonyms.ts';
import { treatRecording } from './treated-reader.ts';

const { PERSONAL_TREATMENT_DROP, PERSONAL_TREATMENT_PSEUDONYM } = PersonalTreatment;
const ID = '1b9d6bcd-bbfd-4b2d-9b5d-ab8dfbbd4bed';
const UNKNOWN_ID = 'ffffffff-bbfd-4b2d-9b5d-ab8dfbbd4bed';
const NAME = 'Ada Lovelace';
const SECRETS = [
  ...[ID, UNKNOWN_ID, 'plain-id', NAME, 'Grace Hopper', 'Old Name', 'Adas Telefon', 'Erika Muster'],
  'Graces Uhr',
  ...[
    'secret note',
    'secret title',
    'secret value',
    'secret list',
    'secret topic',
    'secret user data',
  ],
  ...['secret description', 'secret metadata', 'secret unknown', '10.9.8.7'],
];
const SECRET_TOPIC = '/secret topic/a';
const CODE = '(input) => input.kept';

const label = (topicPattern: string, fieldPath: string, treatment: PersonalTreatment) => ({
  id: '',
  topicPattern,
  fieldPath,
  treatment,
  step: 0,
  note: '',
});

const RULES = {
  ...SHARING_RULES,
  labels: [
    label('/secret topic/**', '', PERSONAL_TREATMENT_DROP),
    label('/text', 'string', PERSONAL_TREATMENT_PSEUDONYM),
    label('/things', 'object2DList.elements.userDataJson', PERSONAL_TREATMENT_DROP),
    label('/list', '', PERSONAL_TREATMENT_PSEUDONYM),
  ],
};

const event = (kind: string, value: object) =>
  ({ kind, timeNs: SAMPLE_START_NS, value }) as unknown as RecordingEvent;

function session(): RecordingEvent {
  const json = toJson('ubii.sessions.Session', {
    name: `${NAME}'s session`,
    authors: ['Erika Muster'],
    processingModules: [
      { name: 'module', authors: ['Erika Muster'], nodeId: ID, onProcessingStringified: CODE },
    ],
    ioMappings: [{ inputMappings: [{ inputName: 'a', topic: `/${ID}/a` }] }],
    extension: { editorJson: JSON.stringify({ notes: `of ${NAME}` }) },
  });
  return event('session', {
    id: 's',
    name: `${NAME}'s session`,
    state: 'running',
    session: JSON.stringify(json),
  });
}

function events(): RecordingEvent[] {
  const marker = { timeMs: 1e12, kind: 'key' };
  return [
    event('client', { id: ID, name: 'Old Name', tags: [], state: 'active' }),
    event('client', { id: ID, name: NAME, tags: [`of ${NAME}`], state: 'active' }),
    event('client', { id: 'plain-id', name: 'Grace Hopper', tags: [], state: 'active' }),
    event('clock', { clientId: ID, offsetMs: 1, errorMs: 1, driftPpm: 0 }),
    event('marker', {
      ...marker,
      id: 'a',
      text: `${NAME} begins, plain-id waits`,
      author: NAME,
      authorId: ID,
    }),
    event('marker', {
      ...marker,
      id: 'b',
      text: '',
      author: 'Grace Hopper',
      authorId: 'plain-id',
      isRemoved: true,
    }),
    event('gap', { topic: `/${ID}/a`, fromMs: 1, untilMs: 2, records: 1, reason: `${NAME} left` }),
    event('gap', { topic: '/secret topic/a', fromMs: 1, untilMs: 2, records: 1, reason: '' }),
    event(
      'device',
      recordedDevice(
        'd',
        ID,
        [{ topic: `/${ID}/a`, name: `of ${NAME}` }, { topic: SECRET_TOPIC }],
        {
          name: 'Graces Uhr',
          tags: [NAME],
        },
      ),
    ),
    session(),
  ];
}

function records(): RecordInit[] {
  return [
    { topic: `/${ID}/position`, format: 'vector2', value: { x: 1, y: 2 } },
    { topic: `/${UNKNOWN_ID}/a`, format: 'double', value: 1 },
    { topic: `/lab/${NAME}/a`, format: 'bool', value: true },
    { topic: '/secret topic/a', format: 'string', value: 'secret value' },
    { topic: '/text', format: 'string', value: 'secret value' },
    { topic: '/chat', format: 'string', value: `old name and ${NAME.toUpperCase()} of ${ID}` },
    {
      topic: '/things',
      format: 'object2DList',
      value: { elements: [{ id: NAME, userDataJson: '"secret user data"' }] },
    },
    { topic: '/list', format: 'stringList', value: { elements: ['secret list', 'secret list'] } },
    {
      topic: '/clients',
      format: 'client',
      value: {
        id: ID,
        name: NAME,
        description: 'secret description',
        hostIp: '10.9.8.7',
        metadataJson: '"secret metadata"',
        devices: [{ name: 'Adas Telefon', clientId: ID }],
      },
    },
    { topic: '/devices', format: 'device', value: { name: 'Adas Telefon', clientId: ID } },
    { topic: '/wall/Adas Telefon', format: 'double', value: 1 },
  ];
}

/** A recording with secrets everywhere, long enough for a snapshot of last values. */
async function tellingFile(): Promise<MemoryFile> {
  const file = new MemoryFile();
  const header = {
    ...SAMPLE_HEADER,
    name: 'secret title',
    notes: 'secret note',
    selection: JSON.stringify({
      clients: [NAME],
      author: 'Grace Hopper',
      devices: ['Adas Telefon'],
    }),
    personalData: JSON.stringify({ labels: [{ topicPattern: '/secret topic/**' }] }),
  };
  const writer = await RecordingWriter.create(file, header);
  for (const each of events()) writer.addEvent(each);
  let seed = 1;
  const data = Uint8Array.from({ length: 5e6 }, () => (seed = (seed * 48_271) % 0x7fffffff));
  const image = { width: 2500, height: 2000, dataFormat: Image2DDataFormat.GRAY8, data };
  const noise: RecordInit = { topic: '/camera', format: 'image2D', value: image };
  const add = async (record: Uint8Array, topic: string, clientId: string): Promise<void> => {
    const times = { logTimeNs: SAMPLE_START_NS, publishTimeNs: SAMPLE_START_NS };
    await writer.addRecord({ topic, clientId, record, ...times });
  };
  for (const record of [...records(), noise, ...records()]) {
    await add(encodeRecord({ ...record, clientId: ID }), record.topic, ID);
  }
  await add(withUnknownField(), '/unknown', 'plain-id');
  await writer.end();
  return file;
}

/** A record with field 5000, which no schema has. */
function withUnknownField(): Uint8Array {
  const record = encode('ubii.topicData.TopicDataRecord', {
    topic: '/unknown',
    clientId: 'plain-id',
    double: 1,
  });
  const text = new TextEncoder().encode('secret unknown');
  return Uint8Array.from([...record, 0xc2, 0xb8, 0x02, text.length, ...text]);
}

function found(content: Buffer): string[] {
  const text = content.toString('latin1').toLowerCase();
  return SECRETS.filter((secret) => text.includes(secret.toLowerCase()));
}

it('[PD-10] [PD-11] [PD-13] nothing personal is left anywhere in a shared file', async () => {
  const file = await tellingFile();
  expect(found(await contentOf(file)).toSorted()).toEqual(SECRETS.toSorted());
  const reader = await RecordingReader.open(file);
  const pseudonyms = new Pseudonyms(createPseudonymKey((bytes) => bytes.fill(3)));
  const treatment = createTreatment(RULES, await findPeople(reader, RULES.labels), pseudonyms);
  const shared = new MemoryFile();
  await treatRecording(reader, shared, treatment);
  const names = (await openFile(shared)).index.attachments.map(({ name }) => name);
  expect(names).toContain(SNAPSHOT_NAME);
  const content = await contentOf(shared);
  expect(content.includes(CODE)).toBe(true);
  expect(found(content)).toEqual([]);
});
