import {
  AccessRole,
  ReplayConflict,
  SessionState,
  StudyBlockState,
  StudyRunState,
  type Init,
  type StudyParticipantRequest,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TRUSTED_CALLER } from '../src/core/ports/caller-facts.ts';
import { TestMaster } from '../src/testing/index.ts';
import { MemoryRecording } from '../src/testing/memory-folder.ts';
import { createGrant, stranger } from './access-world.ts';
import { contentOf, SERVICES, start } from './recording-world.ts';
import { list, play } from './replay-world.ts';
import { doubling, TOPICS } from './sessions/session-world.ts';
import { change, recordingsOf, required, save, startRun } from './study-world.ts';

const CODE = 'Zebra42';
const KEEP_LIVE = ReplayConflict.REPLAY_CONFLICT_KEEP_LIVE;

async function deleteParticipant(
  master: TestMaster,
  studyParticipantRequest: Init<StudyParticipantRequest>,
) {
  const topic = `${SERVICES}study_participant_delete`;
  return required(await master.call({ topic, studyParticipantRequest }), 'studyDeletion');
}

/** An upload of a file, as `copy`. */
function uploadOf(master: TestMaster, bytes: Uint8Array) {
  const receive = (): Promise<void> => {
    master.recordings.uploads.set('copy', new MemoryRecording(bytes));
    return Promise.resolve();
  };
  const isAwaited = (): boolean => true;
  return { id: 'copy', declaredBytes: bytes.length, receive, isAwaited };
}

/** All that the data directory of a master would have, as text. */
function kept(master: TestMaster): string {
  const { storage, studyStorage, grants, audit, recordings } = master;
  const stores = [...Object.values(storage), studyStorage.studies, studyStorage.runs, grants];
  const documents = stores.flatMap((store) => [...store.documents()]);
  const files = [...recordings.files].map(([id, file]) => [id, text(file.bytes)]);
  return JSON.stringify([documents, audit.read(), files]);
}

const text = (bytes: Uint8Array): string => new TextDecoder('latin1').decode(bytes);

describe('a participant', () => {
  it('[ST-50] is listed with runs and recordings', async () => {
    const master = new TestMaster();
    const { id } = await save(master);
    const first = await startRun(master, id, CODE);
    await change(master, first.id, 'begin');
    await change(master, first.id, 'endRun');
    await startRun(master, id, 'P02');
    const second = await startRun(master, id, CODE, '2');
    const topic = `${SERVICES}study_participant_list`;
    const listed = async (request: Init<StudyParticipantRequest>) =>
      required(
        await master.call({ topic, studyParticipantRequest: request }),
        'studyParticipantList',
      ).elements;
    const [recording] = await recordingsOf(master);
    expect(await listed({ studyId: id })).toMatchObject([
      { code: 'P02', number: 2, recordingIds: [] },
      {
        studyId: id,
        code: CODE,
        number: 1,
        sizeBytes: recording!.sizeBytes,
        recordingIds: [recording!.id],
        lastMs: second.startedMs,
      },
    ]);
    expect((await listed({ participantCode: 'zebra42' })).map(({ code }) => code)).toEqual([CODE]);
    expect(await listed({ studyId: 'other' })).toEqual([]);
  });

  it('[ST-51] [ST-52] leaves no trace when it is deleted while a block runs', async () => {
    const master = new TestMaster();
    const ada = await master.extension('Ada');
    const study = await save(master, { consentText: 'Yes?' });
    const run = await startRun(master, study.id, CODE);
    await change(master, run.id, 'consent', { consentVersion: 1 });
    await change(master, run.id, 'begin');
    ada.publish('/x', 'double', 1);
    await change(master, run.id, 'note', { text: `${CODE} laughed` });
    await change(master, run.id, 'end');
    await change(master, run.id, 'begin');
    const other = await startRun(master, study.id, 'P02');
    await change(master, other.id, 'consent', { consentVersion: 1 });
    await change(master, other.id, 'begin');
    const [, , done] = await recordingsOf(master);
    await master.call({
      topic: `${SERVICES}recording_change`,
      recordingChangeRequest: { id: done!.id, name: done!.name, notes: 'good' },
    });
    expect(kept(master)).toContain(CODE);
    const deletion = await deleteParticipant(master, {
      studyId: study.id,
      participantCode: CODE.toLowerCase(),
    });
    expect(deletion).toMatchObject({ runCount: 1, noteCount: 1, studyNames: ['Touch'] });
    expect(deletion.recordingNames.sort()).toEqual([
      `sub-${CODE}_ses-1_task-withHaptics_run-01`,
      `sub-${CODE}_ses-1_task-without_run-01`,
    ]);
    expect(kept(master).toLowerCase()).not.toContain(CODE.toLowerCase());
    expect((await recordingsOf(master)).map(({ name }) => name)).toEqual([
      'sub-P02_ses-1_task-withHaptics_run-01',
    ]);
    const { auditLog } = await master.call({
      topic: '/services/ubii/audit_log',
      auditLogRequest: { service: 'study_participant_delete' },
    });
    expect(auditLog!.entries).toMatchObject([{ object: 'Touch', error: '' }]);
    expect(await startRun(master, study.id, 'P03')).toMatchObject({ participantNumber: 1 });
  });

  it('[ST-51] is deleted in all studies, with copies of its recordings', async () => {
    const master = new TestMaster();
    for (const name of ['Touch', 'Sight']) {
      const { id } = await save(master, { name });
      const run = await startRun(master, id, CODE);
      await change(master, run.id, 'begin');
      await change(master, run.id, 'endRun');
    }
    const [recording] = await recordingsOf(master);
    const { bytes } = master.recordings.files.get(recording!.id)!;
    const upload = uploadOf(master, bytes);
    const { study } = await master.master.uploadRecording(upload, 'Copy', TRUSTED_CALLER);
    expect(study).toMatchObject({ participantCode: CODE });
    const deletion = await deleteParticipant(master, { participantCode: CODE });
    expect(deletion.studyNames.sort()).toEqual(['Sight', 'Touch']);
    expect(deletion.recordingNames).toContain('Copy');
    expect(kept(master)).not.toContain(CODE);
    await expect(deleteParticipant(master, { participantCode: CODE })).rejects.toThrow(
      'There is no participant with this code.',
    );
    await expect(deleteParticipant(master, {})).rejects.toThrow('names no participant');
  });

  it('[RC-41] gets no recordings that a client uploads in the name of a participant', async () => {
    const master = new TestMaster();
    const { id } = await save(master);
    const run = await startRun(master, id, CODE);
    await change(master, run.id, 'begin');
    await change(master, run.id, 'endRun');
    const [recording] = await recordingsOf(master);
    const { bytes } = master.recordings.files.get(recording!.id)!;
    const { token } = await createGrant(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const upload = uploadOf(master, bytes);
    const copy = await master.master.uploadRecording(upload, 'Copy', stranger(token));
    expect(copy.study).toBeUndefined();
    const deletion = await deleteParticipant(master, { participantCode: CODE });
    expect(deletion.recordingNames).not.toContain('Copy');
    expect(deletion.otherRecordings).toEqual([{ id: 'copy', name: 'Copy' }]);
  });

  it('[RP-6] [ST-51] leaves no trace of its replays, ghosts and sessions that ran again', async () => {
    const master = new TestMaster();
    const ada = await master.extension('Ada');
    const { id } = await save(master);
    const run = await startRun(master, id, CODE);
    const mappings = doubling('/x', '/y');
    const { session } = await master.call({ topic: TOPICS.start, session: mappings });
    await master.pass();
    await change(master, run.id, 'begin');
    ada.publish('/x', 'double', 1);
    await change(master, run.id, 'endRun');
    const [recording] = await recordingsOf(master);
    await start(master, {}, 'Of somebody else');
    const recordingId = recording!.id;
    await play(master, { recordingId, isPaused: true, conflict: KEEP_LIVE });
    await play(master, { recordingId, isGhost: true });
    const rerun = await play(master, { recordingId, sessionId: session!.id });
    await master.pass(200);
    const { clientList } = await master.call({ topic: '/services/client/get_list' });
    expect(clientList!.elements.map(({ name }) => name)).toEqual(
      expect.arrayContaining(['Replay of Touch, block 1', 'Ghost of Touch, block 1']),
    );
    await master.call({
      topic: `${SERVICES}client_disconnect`,
      clientDisconnectRequest: { targetId: (await list(master))[0]!.clientIds[0]! },
    });
    const deletion = await deleteParticipant(master, { participantCode: CODE });
    expect(deletion.recordingNames).toContain(`Replay of doubling in ${recording!.name}`);
    await master.pass(1_000);
    expect(await list(master)).toEqual([]);
    expect((await recordingsOf(master)).map(({ id: left }) => left)).not.toContain(
      rerun.session!.comparisonRecordingId,
    );
    expect(kept(master)).not.toContain(CODE);
    const { auditLog } = await master.call({
      topic: `${SERVICES}audit_log`,
      auditLogRequest: { service: 'replay_start' },
    });
    expect(auditLog!.entries.map(({ object }) => object)).toEqual(Array(3).fill(recordingId));
  });

  it('[ST-51] stays listed when a recording of it cannot be deleted, and is deleted again', async () => {
    const master = new TestMaster();
    const { id } = await save(master);
    const run = await startRun(master, id, CODE);
    await change(master, run.id, 'begin');
    await change(master, run.id, 'endRun');
    const remove = master.recordings.delete.bind(master.recordings);
    master.recordings.delete = () => Promise.reject(new Error('no access'));
    await expect(deleteParticipant(master, { participantCode: CODE })).rejects.toThrow();
    master.recordings.delete = remove;
    expect(await deleteParticipant(master, { participantCode: CODE })).toMatchObject({
      runCount: 1,
    });
    expect(kept(master)).not.toContain(CODE);
  });
});

describe('a master that is started again', () => {
  it('[ST-25] has interrupted runs, whose blocks are repeated', async () => {
    const first = new TestMaster();
    const ada = await first.extension('Ada');
    const { id } = await save(first);
    const run = await startRun(first, id);
    await change(first, run.id, 'begin');
    ada.publish('/x', 'double', 1);
    await first.pass(1_500);
    // No `close`: as after kill -9.
    const { clock, studyStorage, recordings } = first;
    const second = new TestMaster({ clock, studyStorage, recordings, idsGiven: 1_000 });
    const get = { topic: `${SERVICES}study_run_get`, studyRunRequest: { id: run.id } };
    const { state, blocks } = required(await second.call(get), 'studyRun');
    expect(state).toBe(StudyRunState.STUDY_RUN_STATE_INTERRUPTED);
    expect(blocks[0]).toMatchObject({ state: StudyBlockState.STUDY_BLOCK_STATE_INTERRUPTED });
    await expect(change(second, run.id, 'repeat', { block: 1 })).rejects.toThrow('Continue it');
    await change(second, run.id, 'continue');
    await change(second, run.id, 'repeat', { block: 1 });
    await change(second, run.id, 'begin');
    const ended = await change(second, run.id, 'endRun');
    expect(ended.blocks[0]!.takes.map(({ name, problem }) => [name, problem])).toEqual([
      ['sub-P01_ses-1_task-withHaptics_run-01', 'The master exited while the block ran.'],
      ['sub-P01_ses-1_task-withHaptics_run-02', ''],
    ]);
    const [, repaired] = await recordingsOf(second);
    expect(repaired).toMatchObject({ state: 3, study: { participantCode: 'P01' } });
    expect((await contentOf(second, repaired!.id)).values).toEqual([['/x', 1]]);
  });

  it('[ST-1] names files that it cannot read in its log, and leaves them alone', async () => {
    const first = new TestMaster();
    const { id } = await save(first);
    const { studyStorage } = first;
    studyStorage.studies.edit('broken', '{ "name": ');
    studyStorage.runs.edit('odd', '{ "blocks": 7 }');
    const second = new TestMaster({ studyStorage, idsGiven: 1_000 });
    const { studyList } = await second.call({ topic: `${SERVICES}study_list` });
    expect(studyList!.elements.map((study) => study.id)).toEqual([id]);
    expect(second.log.lines.filter(({ message }) => message.includes('study'))).toHaveLength(2);
    expect([...studyStorage.studies.documents().keys()]).toContain('broken');
  });
});

describe('the session of a block', () => {
  const session = {
    name: 'Haptics',
    processingModules: [{ name: 'm', onProcessingStringified: '() => ({})' }],
  };

  async function withSession(isStarted: boolean) {
    const master = new TestMaster();
    const added = await master.call({ topic: '/services/session/runtime/add', session });
    const sessionId = added.session!.id;
    const topic = '/services/session/runtime/start';
    if (isStarted) await master.call({ topic, session: { id: sessionId } });
    const { id } = await save(master, { conditions: [{ name: 'a', sessionId }] });
    const run = await startRun(master, id);
    const isLive = async () => {
      await master.pass(50);
      const get = { topic: '/services/session/runtime/get', session: { id: sessionId } };
      const { extension } = required(await master.call(get), 'session');
      return extension?.state === SessionState.SESSION_RUNNING;
    };
    return { master, run, isLive };
  }

  it('[ST-23] starts and stops with the block', async () => {
    const { master, run, isLive } = await withSession(false);
    await change(master, run.id, 'begin');
    expect(await isLive()).toBe(true);
    await change(master, run.id, 'end');
    expect(await isLive()).toBe(false);
  });

  it('[ST-23] stays when it ran before', async () => {
    const { master, run, isLive } = await withSession(true);
    await change(master, run.id, 'begin');
    await change(master, run.id, 'end');
    expect(await isLive()).toBe(true);
  });

  it('[ST-23] keeps the block from beginning when it cannot be started', async () => {
    const master = new TestMaster();
    const { id } = await save(master, { conditions: [{ name: 'a', sessionId: 'gone' }] });
    const run = await startRun(master, id);
    await expect(change(master, run.id, 'begin')).rejects.toThrow('No session has the id "gone".');
    expect(await recordingsOf(master)).toEqual([]);
  });
});
