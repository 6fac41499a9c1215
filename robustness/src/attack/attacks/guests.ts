import type { Member, Outsider } from '@ubii/harness';
import { AccessRole, ReplayConflict, type Init, type ServiceRequest } from '@ubii/proto';

import { recordingFile, recordingFilePath, uploadRecording } from '../../fixtures/recordings.ts';
import { finding, type Attack, type Finding } from '../attack.ts';

const KEEP = ReplayConflict.REPLAY_CONFLICT_KEEP_LIVE;

/** A client that joined, with its address. */
interface Guest extends Member {
  readonly caller: Outsider;
}

/** An action on a recording or study of another client. */
type Deed = (guest: Guest, id: string) => Promise<boolean>;

export const guests: Attack = {
  name: 'guests',
  about: 'a participant takes recordings and studies of other participants and of the admin',
  async run(environment) {
    const master = await environment.startMaster();
    const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const ofTerminal = master.endpoints.joinToken!;
    const [attacker, neighbour, other] = await Promise.all(
      [ofTerminal, ofTerminal, token].map(async (bearer, index): Promise<Guest> => {
        const caller = environment.outsider(master, index);
        return { caller, ...(await caller.join(bearer, { name: `guest ${index}` })) };
      }),
    );
    const insider = environment.insider(master);
    const admin: Guest = { caller: insider, ...(await insider.join(undefined)) };
    const findings: Finding[] = [];
    const owners: readonly [string, Guest][] = [
      ['another guest of its code', neighbour!],
      ['a guest of another invitation', other!],
      ['the admin', admin],
      ['itself', attacker!],
    ];
    for (const [whose, owner] of owners) {
      const isOwn = owner === attacker;
      const recording = await makeRecording(owner);
      findings.push(
        await tryAll(`a recording of ${whose}`, attacker!, recording, RECORDING, isOwn),
      );
      const study = await makeStudy(owner);
      findings.push(await tryAll(`a study of ${whose}`, attacker!, study, STUDY, isOwn));
    }
    return findings;

    async function makeRecording({ caller, bearer }: Guest): Promise<string> {
      const file = await recordingFile('/guest', 10);
      const { recording, refusal } = await uploadRecording(caller, file, { bearer });
      if (recording === undefined) throw new Error(`The upload was refused: ${refusal}`);
      return recording.id;
    }

    async function makeStudy({ caller, bearer }: Guest): Promise<string> {
      const { study, error } = await caller.call(
        {
          topic: '/services/ubii/study_save',
          study: { name: 'study', repetitions: 1, conditions: [{ name: 'one' }] },
        },
        bearer,
      );
      if (study === undefined) throw new Error(`The study was refused: ${error?.message}`);
      return study.id;
    }
  },
};

async function tryAll(
  what: string,
  guest: Guest,
  id: string,
  deeds: Readonly<Record<string, Deed>>,
  isOwn: boolean,
): Promise<Finding> {
  const done: string[] = [];
  for (const [name, deed] of Object.entries(deeds)) {
    if (await deed(guest, id).catch(() => false)) done.push(name);
  }
  const names = Object.keys(deeds);
  const holds = done.length === (isOwn ? names.length : 0);
  return finding(what, done.join(', ') || 'nothing', isOwn ? names.join(', ') : 'nothing', holds);
}

const isDone = async ({ caller, bearer }: Guest, request: Init<ServiceRequest>): Promise<boolean> =>
  (await caller.call(request, bearer)).error === undefined;

/** In the order of their harm: the last one deletes. */
const RECORDING: Readonly<Record<string, Deed>> = {
  async list({ caller, bearer }, id) {
    const { recordingList } = await caller.call({ topic: '/services/ubii/recording_list' }, bearer);
    return recordingList?.elements.some((one) => one.id === id) === true;
  },
  get: (guest, id) =>
    isDone(guest, { topic: '/services/ubii/recording_get', recordingRequest: { id } }),
  async download({ caller, bearer }, id) {
    const headers = { authorization: `Bearer ${bearer}` };
    return (await caller.ask('GET', recordingFilePath(id), headers)).status === 200;
  },
  replay: async (guest, id) => {
    const { replay } = await guest.caller.call(
      {
        topic: '/services/ubii/replay_start',
        replayStartRequest: { recordingId: id, isPaused: true, conflict: KEEP },
      },
      guest.bearer,
    );
    if (replay === undefined) return false;
    await isDone(guest, {
      topic: '/services/ubii/replay_stop',
      replayRequest: { id: replay.id },
    });
    return true;
  },
  mark: (guest, id) =>
    isDone(guest, {
      topic: '/services/ubii/recording_mark',
      recordingMarker: { recordingId: id, clientId: guest.client.id, text: 'a mark' },
    }),
  rename: (guest, id) =>
    isDone(guest, {
      topic: '/services/ubii/recording_change',
      recordingChangeRequest: { id, name: 'taken' },
    }),
  delete: (guest, id) =>
    isDone(guest, { topic: '/services/ubii/recording_delete', recordingRequest: { id } }),
};

const STUDY: Readonly<Record<string, Deed>> = {
  async list({ caller, bearer }, id) {
    const { studyList } = await caller.call({ topic: '/services/ubii/study_list' }, bearer);
    return studyList?.elements.some((one) => one.id === id) === true;
  },
  get: (guest, id) => isDone(guest, { topic: '/services/ubii/study_get', studyRequest: { id } }),
  change: (guest, id) =>
    isDone(guest, {
      topic: '/services/ubii/study_save',
      study: { id, revision: 1, name: 'taken', repetitions: 1, conditions: [{ name: 'one' }] },
    }),
  delete: (guest, id) =>
    isDone(guest, { topic: '/services/ubii/study_delete', studyRequest: { id } }),
};
