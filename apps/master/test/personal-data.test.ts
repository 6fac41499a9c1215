import { PersonalTreatment, type Init, type PersonalLabel } from '@ubii/proto';
import { expect, it } from 'vitest';
import { TestMaster, type TestMasterOptions } from '../src/testing/index.ts';
import { contentOf, SERVICES, start, stop } from './recording-world.ts';

const { PERSONAL_TREATMENT_DROP, PERSONAL_TREATMENT_PSEUDONYM, PERSONAL_TREATMENT_ROUND } =
  PersonalTreatment;
const HEART = {
  topicPattern: '/heart/**',
  fieldPath: 'double',
  treatment: PERSONAL_TREATMENT_ROUND,
  step: 5,
  note: 'Health',
};

async function set(master: TestMaster, ...labels: Init<PersonalLabel>[]) {
  const reply = await master.call({
    topic: `${SERVICES}personal_data_set`,
    personalData: { labels },
  });
  return reply.personalData?.labels ?? reply.error;
}

async function get(master: TestMaster) {
  return (await master.call({ topic: `${SERVICES}personal_data_get` })).personalData?.labels;
}

it('[PD-3] [PD-4] keeps labels with ids of their own, also after a restart', async () => {
  const options: TestMasterOptions = {};
  const master = new TestMaster(options);
  expect(await get(master)).toEqual([]);
  const labels = await set(master, HEART, { ...HEART, id: 'own', fieldPath: '' });
  expect(labels).toMatchObject([HEART, { id: 'own', fieldPath: '' }]);
  expect(await get(master)).toEqual(labels);
  const next = new TestMaster({ personalData: master.personalData });
  expect(await get(next)).toEqual(labels);
  expect(await set(next)).toEqual([]);
  expect(await get(next)).toEqual([]);
});

it.each([
  ['a pattern without topics', { topicPattern: 'heart' }, 'names no topics'],
  ['an unknown member', { fieldPath: 'double.age' }, 'no data format has the member "double.age"'],
  ['an unknown treatment', { treatment: 9 as PersonalTreatment }, 'treatment 9 is unknown'],
  [
    'a pseudonym of a number',
    { treatment: PERSONAL_TREATMENT_PSEUDONYM },
    'values of "double" cannot be replaced by pseudonyms',
  ],
  ['a text that is rounded', { fieldPath: 'string' }, 'values of "string" cannot be rounded'],
  ['a negative step', { step: -1 }, 'the step -1 is no number from 0 on'],
])('[PD-2] refuses %s', async (_, change, message) => {
  const master = new TestMaster();
  const error = await set(master, HEART, { ...HEART, ...change });
  expect(error).toMatchObject({ code: 'invalid_argument' });
  expect(error).toMatchObject({ message: expect.stringContaining(`The label 2 is refused: `) });
  expect(error).toMatchObject({ message: expect.stringContaining(message) });
  expect(await get(master)).toEqual([]);
});

it('[PD-4] refuses two labels of one id, and more labels than the limit', async () => {
  const master = new TestMaster({ limits: { personalLabels: 2 } });
  const drop = { topicPattern: '**', treatment: PERSONAL_TREATMENT_DROP };
  expect(await set(master, { ...drop, id: 'a' }, { ...drop, id: 'a' })).toMatchObject({
    code: 'invalid_argument',
  });
  expect(await set(master, drop, drop, drop)).toMatchObject({ code: 'resource_exhausted' });
});

it('[PD-4] changes are audited', async () => {
  const master = new TestMaster();
  await set(master, HEART);
  const reply = await master.call({ topic: `${SERVICES}audit_log`, auditLogRequest: {} });
  expect(JSON.stringify(reply.auditLog)).toContain('personal_data_set');
});

it('[PD-3] labels that cannot be read are logged, and can be set again', async () => {
  const { personalData } = new TestMaster();
  personalData.edit('labels', '{');
  const master = new TestMaster({ personalData });
  expect(await get(master)).toEqual([]);
  expect(JSON.stringify(master.log.lines)).toContain('the labels of personal data cannot be read');
  expect(await set(master, HEART)).toMatchObject([HEART]);
});

it('[PD-5] labels change neither what subscribers receive nor what is recorded', async () => {
  const master = new TestMaster();
  await set(master, { topicPattern: '/heart/**', treatment: PERSONAL_TREATMENT_DROP });
  const [ada, ben] = [await master.legacy('ada'), await master.legacy('ben')];
  await ben.subscribe({ subscribeTopics: ['/heart/rate'] });
  const id = await start(master);
  ada.publish('/heart/rate', 'double', 71);
  await stop(master, id);
  expect(ben.takeValues()).toEqual([['/heart/rate', 71]]);
  expect((await contentOf(master, id)).values).toEqual([['/heart/rate', 71]]);
});

it('[PD-6] a recording has the labels of its start, and keeps them when it is renamed', async () => {
  const master = new TestMaster();
  await set(master, HEART);
  const id = await start(master);
  await set(master);
  const ada = await master.legacy('ada');
  ada.publish('/heart/rate', 'double', 71);
  await stop(master, id);
  const request = { id, name: 'Other', notes: '' };
  await master.call({ topic: `${SERVICES}recording_change`, recordingChangeRequest: request });
  const { summary } = await contentOf(master, id);
  expect(summary.name).toBe('Other');
  expect(JSON.parse(summary.personalData ?? '')).toMatchObject({
    labels: [{ topicPattern: '/heart/**', fieldPath: 'double', step: 5 }],
  });
});
