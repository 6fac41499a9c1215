import {
  STUDY_STATUS_TOPIC,
  StudyCheckState,
  type Init,
  type StudyDevice,
  type StudyStatus,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { SERVICES } from './recording-world.ts';
import {
  ACTION,
  callAndPass,
  change,
  recordingsOf,
  required,
  save,
  startRun,
} from './study-world.ts';

const { STUDY_CHECK_STATE_OK: OK, STUDY_CHECK_STATE_MISSING: MISSING } = StudyCheckState;
const LOW = StudyCheckState.STUDY_CHECK_STATE_LOW;

/** Texts of what is checked of the first required device, and the state of its row. */
async function check(master: TestMaster, device: Init<StudyDevice>) {
  const { id } = await save(master, { devices: [{ name: 'Phone', ...device }] });
  const request = { topic: `${SERVICES}study_check`, studyRequest: { id } };
  const reply = await callAndPass(master, request, 1_100);
  const { rows, isReady } = required(reply, 'studyCheckList');
  const { state, items, found } = rows[0]!;
  expect(isReady).toBe(state === OK);
  return { state, texts: items.map(({ text }) => text), found };
}

/** A client with a device of this tag that publishes `/<name>/motion` and its battery level. */
async function phone(master: TestMaster, name: string): Promise<TestClient> {
  const client = await master.extension(name);
  const components = [
    { name: 'motion', topic: `/${name}/motion`, messageFormat: 'vector3', tags: ['motion'] },
    { name: 'battery', topic: `/${name}/battery`, messageFormat: 'double' },
  ];
  const device = { name: 'phone', tags: ['phone'], clientId: client.id, components };
  await client.call({ topic: '/services/device/registration', device });
  return client;
}

const move = (client: TestClient, name: string): void =>
  client.publish(`/${name}/motion`, 'vector3', { x: 1, y: 0, z: 0 });

/** News of studies since it was asked last. */
function takeNews(client: TestClient): StudyStatus[] {
  const records = client.takeValues().filter(([topic]) => topic === STUDY_STATUS_TOPIC);
  return records.map(([, value]) => value as StudyStatus);
}

describe('the check list', () => {
  it('[ST-30] finds devices by tag, and clients and devices by topic and data format', async () => {
    const master = new TestMaster();
    expect(await check(master, { tag: 'phone' })).toEqual({
      state: MISSING,
      texts: ['0 of 1 found'],
      found: [],
    });
    const ada = await phone(master, 'Ada');
    const bob = await master.legacy('Bob');
    move(ada, 'Ada');
    bob.publish('/Bob/motion', 'vector3', { x: 0, y: 0, z: 0 });
    expect((await check(master, { tag: 'phone' })).found).toEqual(['Ada: phone']);
    expect((await check(master, { tag: 'motion' })).found).toEqual(['Ada: phone']);
    const both = { state: OK, texts: ['2 of 2 found'], found: ['Ada: phone', 'Bob'] };
    expect(await check(master, { topicPattern: '/*/motion', count: 2 })).toEqual(both);
    expect(await check(master, { dataFormat: 'vector3', count: 2 })).toEqual(both);
    bob.drop();
    expect((await check(master, { dataFormat: 'vector3', count: 2 })).texts).toEqual([
      '1 of 2 found',
    ]);
  });

  it('[ST-30] has battery level and clock error as far as they are reported', async () => {
    const master = new TestMaster();
    const required = { tag: 'phone', minBattery: 0.5, maxClockErrorMs: 5 };
    const ada = await phone(master, 'Ada');
    const [battery, clock] = ['not reported', 'not reported'];
    expect(await check(master, required)).toMatchObject({
      state: MISSING,
      texts: ['1 of 1 found', battery, clock],
    });
    ada.publish(`/${ada.id}/page_state`, 'string', '{"visible":true,"battery":0.4}');
    ada.sendText('PING 1 100 12.5 0');
    expect(await check(master, required)).toMatchObject({
      state: LOW,
      texts: ['1 of 1 found', '40 % (at least 50 %)', '12 ms (at most 5 ms)'],
    });
    ada.publish('/Ada/battery', 'double', 0.9);
    ada.sendText('PING 2 100 1 0');
    expect(await check(master, required)).toMatchObject({
      state: OK,
      texts: ['1 of 1 found', '90 % (at least 50 %)', '1 ms (at most 5 ms)'],
    });
    ada.publish('/Ada/battery', 'double', 7);
    ada.publish(`/${ada.id}/page_state`, 'string', 'broken');
    expect((await check(master, required)).texts[1]).toBe(battery);
  });

  it('[ST-31] keeps a block from beginning until the device is back, unless it is forced', async () => {
    const master = new TestMaster();
    const devices = [{ name: 'Phone', tag: 'phone' }];
    const { id } = await save(master, { devices });
    const run = await startRun(master, id);
    await expect(change(master, run.id, 'begin')).rejects.toThrow(
      'Required devices are not ready: Phone: 0 of 1 found. Set is_forced',
    );
    expect(await recordingsOf(master)).toEqual([]);
    const forced = await change(master, run.id, 'begin', { isForced: true });
    expect(forced.blocks[0]!.takes).toMatchObject([{ forced: 'Phone: 0 of 1 found' }]);
    expect((await recordingsOf(master))[0]!.notes).toContain('Phone: 0 of 1 found');
    await change(master, run.id, 'end');
    await phone(master, 'Ada');
    const ready = await change(master, run.id, 'begin');
    expect(ready.blocks[1]!.takes).toMatchObject([{ forced: '' }]);
  });

  it('[ST-30] [ST-31] measures rates before a block begins', async () => {
    const master = new TestMaster();
    const ada = await phone(master, 'Ada');
    const { id } = await save(master, {
      devices: [{ name: 'Phone', tag: 'phone', minRateHz: 20 }],
    });
    const run = await startRun(master, id);
    const request = {
      topic: `${SERVICES}study_run_change`,
      studyRunChangeRequest: { runId: run.id, action: ACTION.begin },
    };
    const reply = await callAndPass(master, request, 1_100);
    expect(reply.error?.message).toContain('Phone: rate 0 Hz (at least 20 Hz)');
    const cancel = master.clock.every(40, () => move(ada, 'Ada'));
    await master.pass(2_000);
    expect((await master.call(request)).studyRun?.blocks[0]!.takes).toHaveLength(1);
    cancel();
  });
});

describe('news of studies', () => {
  it('[ST-32] [ST-40] have a check list for ten seconds after it was asked for', async () => {
    const master = new TestMaster({ limits: { studyChecks: 1 } });
    const ada = await master.extension('Ada');
    await ada.subscribe({ subscribeTopics: [STUDY_STATUS_TOPIC] });
    const { id } = await save(master, { devices: [{ name: 'Phone', tag: 'phone' }] });
    const other = await save(master);
    takeNews(ada);
    await master.pass(3_000);
    expect(takeNews(ada)).toEqual([]);
    await master.call({ topic: `${SERVICES}study_check`, studyRequest: { id } });
    const tooMany = { topic: `${SERVICES}study_check`, studyRequest: { id: other.id } };
    expect((await master.call(tooMany)).error?.code).toBe('resource_exhausted');
    await phone(master, 'Bob');
    await master.pass(1_000);
    const isReady = true;
    expect(takeNews(ada).at(-1)!.checkLists).toMatchObject([{ studyId: id, isReady }]);
    await master.pass(10_000);
    expect(takeNews(ada).at(-1)!.checkLists).toEqual([]);
    await master.pass(3_000);
    expect(takeNews(ada)).toEqual([]);
  });

  it('[ST-40] tell of open runs each second, without codes', async () => {
    const master = new TestMaster();
    const ada = await master.extension('Ada');
    await ada.subscribe({ subscribeTopics: [STUDY_STATUS_TOPIC] });
    const { id } = await save(master, { blockMs: 60_000 });
    const run = await startRun(master, id, 'Secret7');
    await change(master, run.id, 'begin');
    takeNews(ada);
    await master.pass(3_000);
    const news = takeNews(ada);
    const [recording] = await recordingsOf(master);
    expect(news.map(({ runs }) => runs[0]!.elapsedMs)).toEqual([1_000, 2_000, 3_000]);
    expect(news[0]!.runs).toMatchObject([
      { runId: run.id, studyId: id, block: 1, blockMs: 60_000, recordingId: recording!.id },
    ]);
    expect(JSON.stringify(news)).not.toContain('Secret7');
    await change(master, run.id, 'endRun');
    expect(takeNews(ada).at(-1)!.runs).toEqual([]);
  });
});
