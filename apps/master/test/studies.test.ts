import {
  AccessRole,
  StudyBlockState,
  StudyOrder,
  StudyRunState,
  type Init,
  type Study,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';
import { createGrant, join } from './access-world.ts';
import { contentOf, SERVICES } from './recording-world.ts';
import { change, recordingsOf, required, save, startRun, STUDY } from './study-world.ts';

const statesOf = ({ blocks }: { blocks: readonly { state: StudyBlockState }[] }) =>
  blocks.map(({ state }) => state);
const { STUDY_BLOCK_STATE_PENDING: PENDING, STUDY_BLOCK_STATE_RUNNING: RUNNING } = StudyBlockState;
const { STUDY_BLOCK_STATE_DONE: DONE, STUDY_BLOCK_STATE_SKIPPED: SKIPPED } = StudyBlockState;

describe('a study', () => {
  it('[ST-1] [ST-3] is created, replaced and listed with its numbers', async () => {
    const master = new TestMaster();
    const created = await save(master, { notes: 'Room 3' });
    expect(created).toMatchObject({ name: 'Touch', revision: 1, repetitions: 1 });
    const { id, revision } = created;
    const replaced = await save(master, { id, revision, name: 'Touch 2', repetitions: 2 });
    expect(replaced).toMatchObject({ id, revision: 2, name: 'Touch 2', repetitions: 2, notes: '' });
    await startRun(master, id);
    await startRun(master, id, 'P01', '2');
    const { studyList } = await master.call({ topic: `${SERVICES}study_list` });
    expect(studyList!.elements).toMatchObject([{ id, participantCount: 1, runCount: 2 }]);
  });

  it('[ST-3] is not replaced by who did not see the last change', async () => {
    const master = new TestMaster();
    const { id } = await save(master);
    await save(master, { id, revision: 1, name: 'Mine' });
    await expect(save(master, { id, revision: 1, name: 'Yours' })).rejects.toThrow(
      'The study "Mine" is at revision 2, but revision 1 was changed',
    );
    await expect(save(master, { revision: 1 })).rejects.toThrow('a new study has 0');
    await expect(save(master, { id: 'other' })).rejects.toThrow('No study has the id "other"');
  });

  it.each<[Init<Study>, string]>([
    [{ name: ' ' }, 'member name of the study is empty'],
    [{ conditions: [] }, 'member conditions of the study is empty'],
    [{ conditions: [{ name: '' }] }, 'conditions[0].name of the study is empty'],
    [{ conditions: [{ name: 'a b' }, { name: 'A-B' }] }, 'letters and digits of another one'],
    [{ conditions: [{ name: '灯' }] }, 'without letters from A to Z or digits'],
    [{ order: 9 as StudyOrder }, 'order of the study is 9'],
    [{ blockMs: -1 }, 'block_ms of the study is -1. Set it to a number from 0 to 86400000'],
    [{ nameTemplate: '{participant}/{run}' }, 'the text "/"'],
    [{ devices: [{ name: 'Phone' }] }, 'has 0 of topic_pattern, data_format and tag'],
    [{ devices: [{ name: 'Phone', tag: 'a', dataFormat: 'double' }] }, 'has 2 of topic_pattern'],
    [{ devices: [{ name: 'Phone', tag: 'a', minBattery: 1.5 }] }, 'a number from 0 to 1'],
    [{ devices: [{ name: 'Phone', tag: 'a', minRateHz: Number.NaN }] }, 'min_rate_hz'],
  ])('[ST-3] %o is refused', async (study, message) => {
    await expect(save(new TestMaster(), study)).rejects.toThrow(message);
  });

  it('[ST-2] is refused beyond the limits', async () => {
    const master = new TestMaster({ limits: { studies: 1, studyBlocks: 4 } });
    await save(master);
    await expect(save(master)).rejects.toThrow('more than 1 studies');
    await expect(save(master, { repetitions: 3 })).rejects.toThrow('more than 4 blocks of a run');
  });

  it('[ST-4] is deleted unless it has participants', async () => {
    const master = new TestMaster();
    const { id } = await save(master);
    const other = await save(master, { name: 'Empty' });
    await startRun(master, id);
    const remove = (studyId: string) =>
      master.call({ topic: `${SERVICES}study_delete`, studyRequest: { id: studyId } });
    expect((await remove(id)).error?.message).toContain('has participants');
    expect((await remove(other.id)).error).toBeUndefined();
    expect([...master.studyStorage.studies.documents().keys()]).toEqual([id]);
  });

  it('[ST-5] is for participants and admins', async () => {
    const master = new TestMaster();
    const { id } = await save(master);
    for (const role of [AccessRole.ACCESS_ROLE_VIEWER, AccessRole.ACCESS_ROLE_PLAYER]) {
      const { token } = await createGrant(master, role);
      const guest = await join(master, token, 'Guest');
      const { error } = await guest.call({ topic: `${SERVICES}study_get`, studyRequest: { id } });
      expect(error?.code).toBe('permission_denied');
    }
    const { token } = await createGrant(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const ben = await join(master, token, 'Ben');
    const { study } = await ben.call({ topic: `${SERVICES}study_save`, study: STUDY });
    expect(study).toMatchObject(STUDY);
    const deletion = await ben.call({
      topic: `${SERVICES}study_participant_delete`,
      studyParticipantRequest: { studyId: study!.id, participantCode: 'P01' },
    });
    expect(deletion.error?.code).toBe('permission_denied');
  });
});

describe('a run', () => {
  it('[ST-10] [ST-11] [ST-20] has its blocks in the order of its participant', async () => {
    const master = new TestMaster();
    const conditions = ['a', 'b', 'c', 'd'].map((name) => ({ name }));
    const study = await save(master, { conditions, order: StudyOrder.STUDY_ORDER_BALANCED });
    const orders: string[] = [];
    for (const code of ['P01', 'P02', 'P03', 'P04', 'P05']) {
      const { participantNumber, blocks } = await startRun(master, study.id, code);
      orders.push(`${participantNumber}${blocks.map(({ condition }) => condition).join('')}`);
    }
    expect(orders).toEqual(['1abdc', '2bcad', '3cdba', '4dacb', '5abdc']);
    expect(await startRun(master, study.id, 'p02', '2')).toMatchObject({
      participantCode: 'P02',
      participantNumber: 2,
    });
  });

  it('[ST-20] is not started twice for a participant and visit, nor beyond the limit', async () => {
    const master = new TestMaster({ limits: { openStudyRuns: 2 } });
    const { id } = await save(master);
    const run = await startRun(master, id);
    await expect(startRun(master, id, 'p01')).rejects.toThrow('is not ended');
    await startRun(master, id, 'P01', '2');
    await expect(startRun(master, id, 'P02')).rejects.toThrow('more than 2 open runs');
    await expect(startRun(master, id, 'P 3')).rejects.toThrow('participant_code is "P 3"');
    await change(master, run.id, 'endRun');
    expect(await startRun(master, id)).toMatchObject({ visit: '1', participantNumber: 1 });
    await expect(change(master, run.id, 'continue')).rejects.toThrow('is not ended');
  });

  it('[ST-21] begins, ends, skips and repeats its blocks', async () => {
    const master = new TestMaster();
    const { id } = await save(master, { repetitions: 2 });
    const run = await startRun(master, id);
    expect(statesOf(run)).toEqual([PENDING, PENDING, PENDING, PENDING]);
    const act = async (...[what, more]: [Parameters<typeof change>[2], object?]) =>
      statesOf(await change(master, run.id, what, more));
    expect(await act('begin')).toEqual([RUNNING, PENDING, PENDING, PENDING]);
    await expect(act('begin')).rejects.toThrow('Block 1 of the run is running.');
    expect(await act('skip', { block: 3 })).toEqual([RUNNING, PENDING, SKIPPED, PENDING]);
    expect(await act('end')).toEqual([DONE, PENDING, SKIPPED, PENDING]);
    await expect(act('end')).rejects.toThrow('No block of the run is running.');
    expect(await act('repeat', { block: 1 })).toEqual([PENDING, PENDING, SKIPPED, PENDING]);
    expect(await act('begin', { block: 1 })).toEqual([RUNNING, PENDING, SKIPPED, PENDING]);
    expect(await act('endRun')).toEqual([DONE, PENDING, SKIPPED, PENDING]);
    await expect(act('begin')).rejects.toThrow('The run is not open.');
    const continued = await change(master, run.id, 'continue');
    expect(continued).toMatchObject({ state: StudyRunState.STUDY_RUN_STATE_OPEN, endedMs: 0 });
    expect((await recordingsOf(master)).map(({ name }) => name)).toEqual([
      'sub-P01_ses-1_task-withHaptics_run-02',
      'sub-P01_ses-1_task-withHaptics_run-01',
    ]);
  });

  it('[ST-22] needs the consent that its study asks for', async () => {
    const master = new TestMaster();
    const study = await save(master, { consentText: 'We record how you move.' });
    const ada = await master.extension('Ada');
    const run = await startRun(master, study.id);
    await expect(change(master, run.id, 'begin')).rejects.toThrow('has not consented yet');
    const { id, revision } = study;
    await save(master, { id, revision, consentText: 'We record how you move, and film you.' });
    const consent = (consentVersion: number) =>
      change(master, run.id, 'consent', { consentVersion, clientId: ada.id });
    await expect(consent(1)).rejects.toThrow('read version 1 of the consent text');
    expect((await consent(2)).consent).toEqual({
      version: 2,
      timeMs: master.clock.nowMs(),
      author: 'Ada',
    });
    expect(statesOf(await change(master, run.id, 'begin'))).toEqual([RUNNING, PENDING]);
    const again = await save(master, { id, revision: 2, consentText: 'Third' });
    expect(again).toMatchObject({
      consentVersion: 3,
      earlierConsentTexts: [{ version: 2, text: 'We record how you move, and film you.' }],
    });
  });

  it('[ST-14] [ST-23] [ST-24] records what the study selects, with name, markers and its part', async () => {
    const master = new TestMaster();
    const ada = await master.extension('Ada');
    const study = await save(master, {
      selection: { patterns: ['/lab/**'] },
      nameTemplate: '{study}_{participant}_{condition}_{run}',
    });
    const run = await startRun(master, study.id, 'P07', 'pre');
    ada.publish('/lab/before', 'double', 0);
    await change(master, run.id, 'begin', { clientId: ada.id });
    ada.publish('/lab/x', 'double', 1);
    ada.publish('/other', 'double', 2);
    await master.pass(100);
    await change(master, run.id, 'note', { clientId: ada.id, text: 'Looked\naway' });
    const { blocks, notes } = await change(master, run.id, 'end');
    expect(notes).toMatchObject([{ text: 'Looked\naway', author: 'Ada', block: 1 }]);
    const [take] = blocks[0]!.takes;
    expect(take).toMatchObject({ name: 'Touch_P07_withHaptics_01', runNumber: 1, problem: '' });
    const { values, summary } = await contentOf(master, take!.recordingId);
    expect(values).toEqual([
      ['/lab/before', 0], // [RC-9] [ST-26]
      ['/lab/x', 1],
    ]);
    expect(summary.markers.map(({ text }) => text)).toEqual([
      'Begin of block 1: with haptics',
      'Looked away',
      'End of block 1',
    ]);
    expect((await recordingsOf(master))[0]!.study).toEqual({
      studyId: study.id,
      studyName: 'Touch',
      runId: run.id,
      participantCode: 'P07',
      visit: 'pre',
      condition: 'with haptics',
      block: 1,
      runNumber: 1,
    });
    expect(summary.selection).toContain('"participantCode":"P07"');
  });

  it('[ST-23] ends a block by itself when its time is over', async () => {
    const master = new TestMaster();
    const { id } = await save(master, { blockMs: 2_000 });
    const run = await startRun(master, id);
    await change(master, run.id, 'begin');
    await master.pass(1_000);
    await change(master, run.id, 'end');
    await change(master, run.id, 'begin');
    await master.pass(1_500);
    expect((await recordingsOf(master)).map(({ state }) => state)).toEqual([1, 2]);
    await master.pass(600);
    const studyRunRequest = { id: run.id };
    const reply = await master.call({ topic: `${SERVICES}study_run_get`, studyRunRequest });
    const { blocks } = required(reply, 'studyRun');
    expect(statesOf({ blocks })).toEqual([DONE, DONE]);
    const { startedMs, endedMs } = blocks[1]!.takes[0]!;
    expect(endedMs - startedMs).toBe(2_000);
  });

  it('[ST-2] has no more notes and recordings than the limits allow', async () => {
    const master = new TestMaster({ limits: { studyNotes: 1, studyTakes: 1 } });
    const { id } = await save(master);
    const run = await startRun(master, id);
    await expect(change(master, run.id, 'note', { text: ' ' })).rejects.toThrow('note is empty');
    await change(master, run.id, 'note', { text: 'late' });
    await expect(change(master, run.id, 'note', { text: 'b' })).rejects.toThrow(
      'more than 1 notes',
    );
    await change(master, run.id, 'begin');
    await change(master, run.id, 'end');
    await expect(change(master, run.id, 'begin')).rejects.toThrow('more than 1 recordings');
  });
});
