import {
  decode,
  decodeRecord,
  encodeRecord,
  Image2DDataFormat,
  PersonalTreatment,
  timestampFromMs,
  type PersonalLabel,
  type RecordInit,
} from '@ubii/proto';
import { expect, it } from 'vitest';

import { xdfOf } from '../export/xdf/xdf.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import { MemoryFile } from '../testing/memory-file.ts';
import { recorded } from '../testing/recorded.ts';
import { SAMPLE_HEADER, SAMPLE_START_NS, sampleRecord } from '../testing/sample-records.ts';
import { createTreatment, type Treatment } from './create-treatment.ts';
import { findPeople, type KnownPeople } from './known-people.ts';
import { SHARING_RULES, type PersonalRules } from './personal-rules.ts';
import { createPseudonymKey, Pseudonyms } from './pseudonyms.ts';
import { TreatedReader, treatRecording } from './treated-reader.ts';

const { PERSONAL_TREATMENT_DROP, PERSONAL_TREATMENT_PSEUDONYM, PERSONAL_TREATMENT_ROUND } =
  PersonalTreatment;
const KEY = createPseudonymKey((bytes) => bytes.fill(5));
const NOBODY: KnownPeople = {
  labelled: { texts: new Map<string, string>(), short: 0, isIncomplete: false },
  clientIds: new Set<string>(),
  clientNames: new Set<string>(),
  deviceNames: new Set<string>(),
  foreignTopics: new Set<string>(),
};

function label(fieldPath: string, treatment: PersonalTreatment, step = 0): PersonalLabel {
  return { id: '', topicPattern: '/a', fieldPath, treatment, step, note: '' };
}

function treatmentWith(rules: Partial<PersonalRules>, people = NOBODY): Treatment {
  return createTreatment({ ...SHARING_RULES, ...rules }, people, new Pseudonyms(KEY));
}

function recordOf(init: RecordInit): RecordedRecord {
  const times = { logTimeNs: SAMPLE_START_NS, publishTimeNs: SAMPLE_START_NS };
  return { topic: init.topic, clientId: '', record: encodeRecord(init), ...times };
}

function treated(init: RecordInit, ...labels: PersonalLabel[]): unknown {
  const record = treatmentWith({ labels }).record(recordOf(init));
  return record === undefined ? undefined : decodeRecord(record.record).value;
}

const ADA = new Pseudonyms(KEY).of('Ada', 'id');
const THINGS = {
  topic: '/a',
  format: 'object2DList',
  value: {
    elements: [
      { id: 'Ada', userDataJson: '1', pose: { position: { x: 1.26, y: -3.74 } } },
      { id: 'Ada', userDataJson: '2' },
    ],
  },
} as const;
const IDS = 'object2DList.elements.id';
const POSES = 'object2DList.elements.pose';

it('[PD-1] [PD-2] a pseudonym replaces a member of each element of a list', () => {
  expect(treated(THINGS, label(IDS, PERSONAL_TREATMENT_PSEUDONYM))).toMatchObject({
    elements: [
      { id: ADA, userDataJson: '1', pose: { position: { x: 1.26, y: -3.74 } } },
      { id: ADA, userDataJson: '2' },
    ],
  });
});

it('[PD-2] a dropped member is empty, a dropped list has no elements', () => {
  expect(treated(THINGS, label(POSES, PERSONAL_TREATMENT_DROP))).toMatchObject({
    elements: [{ id: 'Ada', pose: undefined }, { id: 'Ada' }],
  });
  const list = label('object2DList.elements', PERSONAL_TREATMENT_DROP);
  expect(treated(THINGS, list)).toEqual({ elements: [] });
});

it('[PD-2] numbers below a member are rounded to multiples of the step', () => {
  expect(treated(THINGS, label(POSES, PERSONAL_TREATMENT_ROUND, 0.5))).toMatchObject({
    elements: [{ pose: { position: { x: 1.5, y: -3.5 } } }, { pose: undefined }],
  });
  const whole = label('', PERSONAL_TREATMENT_ROUND);
  expect(treated({ topic: '/a', format: 'double', value: 71.6 }, whole)).toBe(72);
  expect(treated({ topic: '/a', format: 'double', value: NaN }, whole)).toBeNaN();
  const tens = label('', PERSONAL_TREATMENT_ROUND, 10);
  expect(treated({ topic: '/a', format: 'int32', value: 17 }, tens)).toBe(20);
  const list = { topic: '/a', format: 'doubleList', value: { elements: [1.04, 2.06] } } as const;
  const tenths = label('', PERSONAL_TREATMENT_ROUND, 0.1);
  expect(treated(list, tenths)).toEqual({ elements: [1, 2.1] });
});

it('[PD-2] labels of one record apply one after the other', () => {
  const labels = [
    label(IDS, PERSONAL_TREATMENT_PSEUDONYM),
    label('object2DList.elements.userDataJson', PERSONAL_TREATMENT_DROP),
  ];
  expect(treated(THINGS, ...labels)).toMatchObject({
    elements: [
      { id: ADA, userDataJson: '' },
      { id: ADA, userDataJson: '' },
    ],
  });
});

const IMAGE = {
  topic: '/a',
  format: 'image2D',
  value: { width: 2, height: 1, dataFormat: Image2DDataFormat.GRAY8, data: Uint8Array.of(9, 9) },
} as const;

it.each([
  [
    'a number that cannot have a pseudonym',
    { topic: '/a', format: 'double', value: 1 },
    label('', PERSONAL_TREATMENT_PSEUDONYM),
  ],
  [
    'a text that cannot be rounded',
    { topic: '/a', format: 'string', value: 'Ada' },
    label('string', PERSONAL_TREATMENT_ROUND),
  ],
  ['a value of a format that is dropped', IMAGE, label('image2D', PERSONAL_TREATMENT_DROP)],
  [
    'a topic whose label names an unknown member',
    THINGS,
    label('object2DList.elements.age', PERSONAL_TREATMENT_DROP),
  ],
  ['a topic whose label has an unknown treatment', THINGS, label('', 7 as PersonalTreatment)],
] as [string, RecordInit, PersonalLabel][])('[PD-2] %s is dropped', (_, init, each) => {
  expect(treated(init, each)).toBeUndefined();
});

it('[PD-2] pixels below a label are emptied, as nobody knows what they show', () => {
  expect(treated(IMAGE, label('', PERSONAL_TREATMENT_ROUND))).toMatchObject({
    data: new Uint8Array(),
  });
});

it('[PD-14] what no rule touches stays bit for bit', () => {
  const treatment = treatmentWith({ labels: [label('', PERSONAL_TREATMENT_DROP)] });
  const text = recordOf({ topic: '/b', format: 'string', value: 'nobody' });
  // Field 5000 is in no schema.
  const unknown = { ...text, record: Uint8Array.from([...text.record, 0xc0, 0xb8, 0x02, 1]) };
  expect(treatment.record(unknown)?.record).toBe(unknown.record);
});

it('[PD-12] the code of modules stays as it is, whatever is in it', () => {
  const code = "() => 'Ada'";
  const session = JSON.stringify({
    processingModules: [{ name: 'by Ada', onProcessingStringified: code, nodeId: 'ada' }],
  });
  const people = { ...NOBODY, clientNames: new Set(['Ada']) };
  const event = {
    kind: 'session',
    timeNs: 1n,
    value: { id: 's', name: 'of Ada', state: '', session },
  };
  const value = treatmentWith({}, people).event(event as RecordingEvent)!.value as {
    session: string;
  };
  const pseudonym = new Pseudonyms(KEY).of('Ada', 'client');
  expect(value).toMatchObject({ name: `of ${pseudonym}` });
  expect(JSON.parse(value.session)).toMatchObject({
    processingModules: [
      {
        name: `by ${pseudonym}`,
        onProcessingStringified: code,
        nodeId: new Pseudonyms(KEY).of('ada', 'client'),
      },
    ],
  });
});

it('[PD-15] a shift moves all times alike', async () => {
  const init = { topic: '/a', format: 'double', value: 1 } as const;
  const ms = Number(SAMPLE_START_NS / 1_000_000n);
  const timed = { ...recordOf(init), record: encodeRecord({ ...init, timestampMs: ms }) };
  const event: RecordingEvent = {
    kind: 'marker',
    timeNs: SAMPLE_START_NS,
    value: { id: 'm', timeMs: ms, text: '', author: '', authorId: '', kind: '' },
  };
  const reader = await RecordingReader.open(await recorded([timed], [event]));
  const treatment = treatmentWith({ time: 'shift' }, await findPeople(reader, []));
  const file = new MemoryFile();
  await treatRecording(reader, file, treatment);
  const shared = await RecordingReader.open(file);
  const shiftNs = BigInt(KEY.shiftMs) * 1_000_000n;
  expect(shared.summary).toMatchObject({ startNs: SAMPLE_START_NS + shiftNs });
  expect(shared.summary.markers).toMatchObject([{ timeMs: ms + KEY.shiftMs }]);
  const latest = (await shared.latestAt(shared.summary.endNs)).get('/a')!;
  expect(latest.publishTimeNs).toBe(SAMPLE_START_NS + shiftNs);
  const { timestamp } = decode('ubii.topicData.TopicDataRecord', latest.record);
  expect(timestamp).toEqual(timestampFromMs(ms + KEY.shiftMs));
});

it('[PD-11] [PD-13] rules that keep everything change nothing but the selection', async () => {
  const record = sampleRecord('/1b9d6bcd-bbfd-4b2d-9b5d-ab8dfbbd4bed/a', 0);
  const reader = await RecordingReader.open(await recorded([record]));
  const rules = { ...SHARING_RULES, clients: 'keep', notes: 'keep' } as const;
  const treatment = treatmentWith(rules, await findPeople(reader, []));
  expect(treatment.record(record)).toEqual(record);
  expect(treatment.header({ ...SAMPLE_HEADER, selection: '{"topics":[]}' })).toEqual(SAMPLE_HEADER);
});

it('exports read a treated recording by its shared topics and times', async () => {
  const client: RecordingEvent = {
    kind: 'client',
    timeNs: SAMPLE_START_NS,
    value: { id: 'ada', name: 'Ada', tags: [], state: 'active' },
  };
  const records = [
    sampleRecord('/ada/a', 0),
    sampleRecord('/ada/a', 10),
    sampleRecord('/dropped', 5),
  ];
  const reader = await RecordingReader.open(await recorded(records, [client]));
  const labels = [{ ...label('', PERSONAL_TREATMENT_DROP), topicPattern: '/dropped' }];
  const treatment = treatmentWith({ labels, time: 'shift' }, await findPeople(reader, []));
  const shared = new TreatedReader(reader, treatment);
  const topic = treatment.topic('/ada/a')!;
  expect(topic).toMatch(/^\/client-[0-9a-f]{6}\/a$/);
  expect(shared.summary.topics).toMatchObject([{ topic, clientId: topic.split('/')[1] }]);
  const { startNs, endNs } = shared.summary;
  expect([...(await shared.latestAt(startNs + 5_000_000n)).values()]).toMatchObject([
    { topic, logTimeNs: startNs },
  ]);
  const read = [];
  for await (const { logTimeNs } of shared.records({ topics: [topic], fromNs: startNs + 1n }))
    read.push(logTimeNs);
  expect(read).toEqual([endNs]);
  const parts = [];
  for await (const part of xdfOf(shared)) parts.push(part);
  const xdf = Buffer.concat(parts).toString();
  expect(xdf).toContain(topic);
  expect(xdf).not.toMatch(/ada|dropped/i);
});

it('treating ends when it is cancelled', async () => {
  const reader = await RecordingReader.open(await recorded([sampleRecord('/a', 0)]));
  const abort = new AbortController();
  abort.abort(new Error('Cancelled'));
  const { signal } = abort;
  const treatment = treatmentWith({}, await findPeople(reader, []));
  await expect(treatRecording(reader, new MemoryFile(), treatment, { signal })).rejects.toThrow(
    'Cancelled',
  );
});

it('[PD-14] messages of other programs are dropped', () => {
  const treatment = treatmentWith({}, { ...NOBODY, foreignTopics: new Set(['/imu']) });
  expect(treatment.topic('/imu')).toBeUndefined();
  expect(treatment.record(sampleRecord('/imu', 0))).toBeUndefined();
});
