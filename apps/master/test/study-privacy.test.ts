import {
  AccessRole,
  RECORDING_STATUS_TOPIC,
  type Init,
  type Recording,
  type Study,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { DEFAULT_FLIGHT_RECORDER } from '../src/core/recordings/flight-settings.ts';
import { TestMaster } from '../src/testing/index.ts';
import { joinAs } from './access-world.ts';
import { contentOf, SERVICES, start, stop } from './recording-world.ts';
import { change, recordingsOf, required, save, startRun } from './study-world.ts';

async function begun(studyInit: Init<Study> = {}) {
  const master = new TestMaster();
  const ada = await master.extension('Ada');
  const study = await save(master, studyInit);
  const answer = (value: string): void => ada.publish('/lab/answer', 'string', value);
  const runOf = async (code: string, visit = '') =>
    (await startRun(master, study.id, code, visit)).id;
  /** Values with which the recording of the next block begins. */
  const firstValues = async (runId: string) => {
    await change(master, runId, 'begin');
    const { blocks } = await change(master, runId, 'end');
    const take = blocks.flatMap(({ takes }) => takes).at(-1)!;
    return (await contentOf(master, take.recordingId)).values;
  };
  return { master, ada, study, answer, runOf, firstValues };
}

async function deleteParticipant(master: TestMaster, participantCode: string) {
  const studyParticipantRequest = { participantCode };
  const topic = `${SERVICES}study_participant_delete`;
  return required(await master.call({ topic, studyParticipantRequest }), 'studyDeletion');
}

describe('the recording of a participant', () => {
  it('[ST-26] does not begin with values of the participant before', async () => {
    const { master, answer, runOf, firstValues } = await begun();
    answer('pilot');
    const first = await runOf('P01');
    expect(await firstValues(first)).toEqual([]);
    answer('of P01');
    expect(await firstValues(first)).toEqual([['/lab/answer', 'of P01']]);
    await change(master, first, 'endRun');
    answer('of P01, afterwards');
    const second = await runOf('P02');
    expect(await firstValues(second)).toEqual([]);
    answer('of P02');
    expect(await firstValues(second)).toEqual([['/lab/answer', 'of P02']]);
  });

  it('[ST-26] does not begin with values of a participant whose run was open as well', async () => {
    const { master, answer, runOf, firstValues } = await begun();
    const first = await runOf('P01');
    const second = await runOf('P02');
    answer('of P01 or P02');
    expect(await firstValues(first)).toEqual([]);
    await change(master, second, 'endRun');
    expect(await firstValues(first)).toEqual([]);
  });

  it('[ST-26] does not begin with values of a run that came while its own was ended', async () => {
    const { master, answer, runOf, firstValues } = await begun();
    const first = await runOf('P01');
    await change(master, first, 'endRun');
    const second = await runOf('P02');
    answer('of P02');
    await change(master, second, 'endRun');
    await change(master, first, 'continue');
    expect(await firstValues(first)).toEqual([]);
  });

  it('[ST-26] does not begin with values of a participant with the same code in another study', async () => {
    const { master, answer, runOf, firstValues } = await begun();
    const other = await save(master, { name: 'Sight' });
    const run = await startRun(master, other.id, 'P01');
    answer('of P01 of the other study');
    const first = await runOf('P01');
    await change(master, run.id, 'endRun');
    expect(await firstValues(first)).toEqual([]);
  });

  it('[ST-26] begins with settings that the study names, whenever they were published', async () => {
    const settingPatterns = ['/room/**', ' '];
    const { ada, study, answer, runOf, firstValues } = await begun({ settingPatterns });
    expect(study.settingPatterns).toEqual(['/room/**']);
    ada.publish('/room/brightness', 'double', 0.4);
    answer('pilot');
    expect(await firstValues(await runOf('P01'))).toEqual([['/room/brightness', 0.4]]);
    await runOf('P02');
    expect(await firstValues(await runOf('P03'))).toEqual([['/room/brightness', 0.4]]);
  });
});

describe('the deletion of a participant', () => {
  it('[ST-53] names recordings of the same time that stay', async () => {
    const { master, answer, runOf } = await begun();
    const before = await start(master, {}, 'Before');
    answer('pilot');
    await stop(master, before);
    await master.pass(60_000);
    const first = await runOf('P01');
    const byHand = await start(master, {}, 'By hand');
    answer('of P01');
    await change(master, first, 'begin');
    const second = await runOf('P02');
    await change(master, second, 'begin');
    await change(master, first, 'endRun');
    await stop(master, byHand);
    await change(master, second, 'endRun');
    await master.pass(60_000);
    const later = await start(master, {}, 'Later');
    await stop(master, later);
    const { otherRecordings } = await deleteParticipant(master, 'P01');
    expect(otherRecordings.map(({ name }) => name).sort()).toEqual([
      'By hand',
      'sub-P02_ses-1_task-withHaptics_run-01',
    ]);
    expect(otherRecordings.map(({ id }) => id)).toContain(byHand);
    const left = (await recordingsOf(master)).map(({ name }) => name);
    expect(left).toEqual(expect.arrayContaining(['Before', 'By hand', 'Later']));
  });

  it('[RC-34] [ST-53] empties the flight recorder, which goes on', async () => {
    const master = new TestMaster({ flightRecorder: DEFAULT_FLIGHT_RECORDER });
    const ada = await master.extension('Ada');
    const { id } = await save(master);
    await startRun(master, id, 'P01');
    ada.publish('/lab/answer', 'string', 'of P01');
    await master.pass(1_000);
    await deleteParticipant(master, 'P01');
    ada.publish('/lab/x', 'double', 1);
    await master.pass(1_000);
    const topic = `${SERVICES}flight_recorder_keep`;
    const reply = await master.call({ topic, flightRecorderKeepRequest: {} });
    const { values } = await contentOf(master, required(reply, 'recording').id);
    expect(values).toEqual([['/lab/x', 1]]);
  });
});

describe('recordings of studies', () => {
  it('[ST-54] are announced to everybody without the participant', async () => {
    const { master, ada, runOf } = await begun({ devices: [{ name: 'Phone', tag: 'touch' }] });
    await ada.subscribe({ subscribeTopics: [RECORDING_STATUS_TOPIC] });
    const run = await runOf('P01');
    await change(master, run, 'begin', { isForced: true });
    await master.pass(1_500);
    const records = ada.takeRecords();
    expect(JSON.stringify(records)).toContain('"name":"Touch, block 1"');
    expect(JSON.stringify(records)).not.toMatch(/P01|Begun although/);
  });

  it('[ST-54] are named without the participant to viewers, also while they are replayed', async () => {
    const { master, ada, runOf } = await begun();
    const run = await runOf('P01');
    await change(master, run, 'begin');
    ada.publish('/lab/answer', 'string', 'yes');
    await master.pass(100);
    await change(master, run, 'end');
    const viewer = await joinAs(master, AccessRole.ACCESS_ROLE_VIEWER);
    await viewer.subscribe({ subscribeTopicRegexp: ['.*'] });
    const [{ id: recordingId }] = (await recordingsOf(master)) as [Recording];
    const topic = `${SERVICES}replay_start`;
    required(await master.call({ topic, replayStartRequest: { recordingId } }), 'replay');
    await master.pass(500);
    const { replayList } = await viewer.call({ topic: `${SERVICES}replay_list` });
    expect(replayList!.elements).toMatchObject([{ recordingName: 'Touch, block 1', recordingId }]);
    expect(JSON.stringify([replayList, viewer.takeRecords()])).not.toContain('P01');
  });
});
