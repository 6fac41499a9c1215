import {
  AccessRole,
  StudyRunAction,
  type Init,
  type ServiceReply,
  type ServiceRequest,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { LOCAL_CALLER } from '../src/core/ports/caller-facts.ts';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { createGrant, join, joinAs, NETWORK_CALLER, stranger } from './access-world.ts';
import { SERVICES } from './recording-world.ts';
import { required, STUDY } from './study-world.ts';

const { ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_VIEWER } = AccessRole;

/** Anything that calls services: a client, an admin without one, a program. */
interface Caller {
  call(request: Init<ServiceRequest>): Promise<ServiceReply>;
}

const ask = (caller: Caller, service: string, payload: Omit<Init<ServiceRequest>, 'topic'> = {}) =>
  caller.call({ topic: `${SERVICES}${service}`, ...payload });

/** Starts a recording. Returns its id. */
async function record(caller: Caller, name = 'Lesson'): Promise<string> {
  const recordingStartRequest = { name };
  const reply = await ask(caller, 'recording_start', { recordingStartRequest });
  return required(reply, 'recording').id;
}

async function recordAndStop(caller: Caller, name?: string): Promise<string> {
  const id = await record(caller, name);
  required(await ask(caller, 'recording_stop', { recordingRequest: { id } }), 'recording');
  return id;
}

async function namesFor(caller: Caller): Promise<string[]> {
  const reply = await ask(caller, 'recording_list');
  return required(reply, 'recordingList').elements.map(({ name }) => name);
}

async function saveStudy(caller: Caller, name: string) {
  return required(await ask(caller, 'study_save', { study: { ...STUDY, name } }), 'study');
}

async function studiesFor(caller: Caller): Promise<string[]> {
  return required(await ask(caller, 'study_list'), 'studyList').elements.map(({ name }) => name);
}

/** All that can be done with a recording. */
const USES: readonly [service: string, payload: (id: string) => Init<ServiceRequest>][] = [
  ['recording_get', (id) => ({ recordingRequest: { id } })],
  ['recording_stop', (id) => ({ recordingRequest: { id } })],
  ['recording_change', (id) => ({ recordingChangeRequest: { id, name: 'Mine' } })],
  ['recording_upload', (id) => ({ recordingRequest: { id } })],
  ['recording_mark', (id) => ({ recordingMarker: { recordingId: id, text: 'x' } })],
  ['replay_start', (id) => ({ replayStartRequest: { recordingId: id } })],
  ['recording_delete', (id) => ({ recordingRequest: { id } })],
];

async function codesOf(caller: Caller, id: string): Promise<[string, string][]> {
  const codes: [string, string][] = [];
  for (const [service, payload] of USES) {
    const { error } = await ask(caller, service, payload(id));
    codes.push([service, error?.code ?? '']);
  }
  return codes;
}

const REFUSED = USES.map(([service]) => [service, 'permission_denied']);

/** A program of the machine of the master, which has no token. */
function local(master: TestMaster): Caller {
  return { call: (request) => master.call(request, LOCAL_CALLER) };
}

async function terminalCode(master: TestMaster): Promise<string> {
  return (await master.master.openTerminal(true)).join!.code;
}

/** A second tab: another client, with the credential of the first. */
function secondTab(master: TestMaster, first: TestClient): Promise<TestClient> {
  return join(master, first.registered.extension!.credential);
}

describe('recordings', () => {
  it('[RC-5] [RC-21] [RC-66] of another invitation are not listed, read, changed, played and deleted', async () => {
    const master = new TestMaster();
    const ada = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    const bob = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    ada.publish('/x', 'double', 1);
    const id = await recordAndStop(ada, 'of Ada');
    await recordAndStop(bob, 'of Bob');
    expect(await codesOf(bob, id)).toEqual(REFUSED);
    expect([await namesFor(ada), await namesFor(bob)]).toEqual([['of Ada'], ['of Bob']]);
    expect((await namesFor(master)).sort()).toEqual(['of Ada', 'of Bob']);
    const codes = await codesOf(ada, id);
    expect(codes.filter(([, code]) => code !== '')).toEqual([['recording_upload', 'not_found']]);
  });

  it('[RC-66] of an invitation are those of all that joined with it', async () => {
    const master = new TestMaster();
    const { token } = await createGrant(master, ACCESS_ROLE_PARTICIPANT);
    const [ada, bob] = [await join(master, token), await join(master, token)];
    await recordAndStop(ada, 'of the team');
    expect(await namesFor(bob)).toEqual(['of the team']);
  });

  it("[RC-66] of the terminal's code are those of one client, and of its further tabs", async () => {
    const master = new TestMaster();
    const code = await terminalCode(master);
    const [ada, bob] = [await join(master, code), await join(master, code)];
    const id = await recordAndStop(ada, 'of Ada');
    expect(await namesFor(bob)).toEqual([]);
    expect(await codesOf(bob, id)).toEqual(REFUSED);
    const tab = await secondTab(master, ada);
    const third = await secondTab(master, tab);
    await recordAndStop(tab, 'of her tab');
    for (const one of [ada, tab, third]) {
      expect(one.id === ada.id ? [] : [ada.id]).not.toContain(one.id);
      expect((await namesFor(one)).sort()).toEqual(['of Ada', 'of her tab']);
    }
  });

  it("[RC-66] of the terminal's code are found again by a client that comes back", async () => {
    const before = new TestMaster();
    const code = await terminalCode(before);
    const ada = await join(before, code);
    await recordAndStop(ada, 'of Ada');
    const { recordings, grants, clock } = before;
    const master = new TestMaster({ recordings, grants, clock, idsGiven: 1_000 });
    const { id, token: resumeToken } = ada;
    const client = { id, name: 'phone', extension: { resumeToken } };
    const back = await master.register(client, ada.caller);
    expect([back.id, await namesFor(back)]).toEqual([id, ['of Ada']]);
    const other = await join(master, (await master.master.openTerminal(true)).join!.code);
    expect(await namesFor(other)).toEqual([]);
  });

  it('[RC-66] of admins are not those of programs of this machine, and not the other way round', async () => {
    const master = new TestMaster();
    const ofAdmin = await recordAndStop(master, 'of the admin');
    await recordAndStop(local(master), 'of a program');
    expect(await codesOf(local(master), ofAdmin)).toEqual(REFUSED);
    expect(await namesFor(local(master))).toEqual(['of a program']);
    const network: Caller = { call: (request) => master.call(request, NETWORK_CALLER) };
    expect(await namesFor(network)).toEqual([]);
    expect(await namesFor(master)).toHaveLength(2);
  });

  it('[RC-3] [RC-66] are not listed for viewers and strangers', async () => {
    const master = new TestMaster();
    const id = await recordAndStop(master);
    const viewer = await joinAs(master, ACCESS_ROLE_VIEWER);
    expect(await codesOf(viewer, id)).toEqual(REFUSED);
    expect((await ask(viewer, 'recording_list')).error?.code).toBe('permission_denied');
    await expect(master.master.requireRecording(id, viewer.caller)).rejects.toThrow(
      /Only an admin/,
    );
    await expect(master.master.requireRecording(id, stranger())).rejects.toThrow(/Only an admin/);
  });

  it('[RC-40] [RC-66] are sent as files to their maker and to admins', async () => {
    const master = new TestMaster();
    const ada = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    const bob = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    const id = await recordAndStop(ada);
    const file = (caller = ada.caller) => master.master.requireRecording(id, caller);
    await expect(file()).resolves.toMatchObject({ id });
    await expect(file(bob.caller)).rejects.toMatchObject({ code: 'permission_denied' });
    await expect(file(LOCAL_CALLER)).rejects.toMatchObject({ code: 'permission_denied' });
  });

  it('[RC-21] that run are marked by all, who change no markers of others', async () => {
    const master = new TestMaster();
    const ada = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    const bob = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    const recordingId = await record(ada);
    const mark = async (by: TestClient, marker: object) =>
      ask(by, 'recording_mark', { recordingMarker: { clientId: by.id, ...marker } });
    const { id } = required(await mark(bob, { text: 'of Bob' }), 'recordingMarker');
    const own = required(await mark(ada, { text: 'of Ada' }), 'recordingMarker').id;
    const refused = { code: 'permission_denied' };
    expect((await mark(bob, { id: own, text: 'no' })).error).toMatchObject(refused);
    expect((await mark(bob, { id: own, recordingId, text: 'no' })).error).toMatchObject(refused);
    expect((await mark(bob, { id, recordingId, text: 'mine' })).error).toBeUndefined();
    expect((await mark(ada, { id, recordingId, text: 'edited' })).error).toBeUndefined();
  });

  it('[RC-8] that run are announced without notes', async () => {
    const master = new TestMaster();
    const viewer = await joinAs(master, ACCESS_ROLE_VIEWER);
    await viewer.subscribe({ subscribeTopics: ['/ubii/recordings'] });
    const recordingStartRequest = { name: 'Lesson', notes: 'of the left hand' };
    await ask(master, 'recording_start', { recordingStartRequest });
    await master.pass(1_500);
    const told = JSON.stringify(viewer.takeRecords());
    expect(told).toContain('Lesson');
    expect(told).not.toContain('left hand');
  });

  it('[RP-6] [RC-66] are played in replays that others do not control', async () => {
    const master = new TestMaster();
    const program = local(master);
    const publisher = await master.extension('publisher');
    const id = await record(master);
    publisher.publish('/x', 'double', 1);
    await master.pass(100);
    await ask(master, 'recording_stop', { recordingRequest: { id } });
    const replayStartRequest = { recordingId: id };
    const { replay } = await ask(master, 'replay_start', { replayStartRequest });
    const request = { replayRequest: { id: replay!.id } };
    const { error } = await ask(program, 'replay_stop', request);
    expect(error).toMatchObject({ code: 'permission_denied' });
    expect((await ask(master, 'replay_stop', request)).error).toBeUndefined();
  });
});

describe('studies', () => {
  /** All that can be done with a study and a run. */
  const STUDY_USES: readonly [
    string,
    (study: string, run: string) => Omit<Init<ServiceRequest>, 'topic'>,
  ][] = [
    ['study_get', (id) => ({ studyRequest: { id } })],
    ['study_save', (id) => ({ study: { ...STUDY, id, revision: 1 } })],
    ['study_check', (id) => ({ studyRequest: { id } })],
    [
      'study_run_start',
      (studyId) => ({ studyRunStartRequest: { studyId, participantCode: 'P02' } }),
    ],
    ['study_run_get', (_, id) => ({ studyRunRequest: { id } })],
    [
      'study_run_change',
      (_, runId) => {
        const action = StudyRunAction.STUDY_RUN_ACTION_END;
        return { studyRunChangeRequest: { runId, action } };
      },
    ],
    ['study_delete', (id) => ({ studyRequest: { id } })],
  ];

  it('[ST-5] of others are not listed, read, changed, run and deleted', async () => {
    const master = new TestMaster();
    const code = await terminalCode(master);
    const [ada, bob] = [await join(master, code), await join(master, code)];
    const study = await saveStudy(ada, 'of Ada');
    const studyRunStartRequest = { studyId: study.id, participantCode: 'P01' };
    const { id } = required(
      await ask(ada, 'study_run_start', { studyRunStartRequest }),
      'studyRun',
    );
    for (const other of [bob, local(master)]) {
      for (const [service, payload] of STUDY_USES) {
        const { error } = await ask(other, service, payload(study.id, id));
        expect([service, error?.code]).toEqual([service, 'permission_denied']);
      }
      expect(await studiesFor(other)).toEqual([]);
      const runs = await ask(other, 'study_run_list', { studyRunListRequest: {} });
      expect(runs.studyRunList!.elements).toEqual([]);
      const people = await ask(other, 'study_participant_list', { studyParticipantRequest: {} });
      expect(people.studyParticipantList!.elements).toEqual([]);
    }
    expect([await studiesFor(ada), await studiesFor(master)]).toEqual([['of Ada'], ['of Ada']]);
    for (const [service, payload] of STUDY_USES.slice(0, -1)) {
      const { error } = await ask(ada, service, payload(study.id, id));
      expect([service, error?.code]).toEqual([service, undefined]);
    }
  });

  it('[ST-5] have recordings of their own maker, also when an admin leads the block', async () => {
    const master = new TestMaster();
    const ada = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    const bob = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    const study = await saveStudy(ada, 'of Ada');
    const studyRunStartRequest = { studyId: study.id, participantCode: 'P01' };
    const run = required(await ask(ada, 'study_run_start', { studyRunStartRequest }), 'studyRun');
    const action = StudyRunAction.STUDY_RUN_ACTION_BEGIN_BLOCK;
    const begun = await ask(master, 'study_run_change', {
      studyRunChangeRequest: { runId: run.id, action },
    });
    required(begun, 'studyRun');
    expect(await namesFor(ada)).toEqual(['sub-P01_ses-1_task-withHaptics_run-01']);
    expect(await namesFor(bob)).toEqual([]);
    const { studyParticipantList } = await ask(ada, 'study_participant_list', {
      studyParticipantRequest: {},
    });
    expect(studyParticipantList!.elements).toMatchObject([{ code: 'P01' }]);
  });

  it('[ST-5] keep their maker after a restart and a change by an admin; older ones are admins', async () => {
    const before = new TestMaster();
    const ada = await joinAs(before, ACCESS_ROLE_PARTICIPANT);
    const study = await saveStudy(ada, 'of Ada');
    await saveStudy(before, 'of the admin');
    const changed = { ...STUDY, id: study.id, revision: 1, name: 'of Ada, changed' };
    required(await ask(before, 'study_save', { study: changed }), 'study');
    const { studyStorage, grants, clock } = before;
    const master = new TestMaster({ studyStorage, grants, clock, idsGiven: 1_000 });
    expect(await studiesFor({ call: (request) => master.call(request, ada.caller) })).toEqual([
      'of Ada, changed',
    ]);
    expect(await studiesFor(master)).toHaveLength(2);
    expect(await studiesFor(local(master))).toEqual([]);
  });
});
