import {
  decode,
  encode,
  StudyRunAction,
  type Init,
  type ServiceReply,
  type ServiceRequest,
  type Study,
  type StudyRun,
  type StudyRunChangeRequest,
} from '@ubii/proto';
import { TRUSTED_CALLER } from '../src/core/ports/caller-facts.ts';
import type { TestMaster } from '../src/testing/index.ts';
import { SERVICES } from './recording-world.ts';

/** What can be done with a run. */
export const ACTION = {
  consent: StudyRunAction.STUDY_RUN_ACTION_CONSENT,
  begin: StudyRunAction.STUDY_RUN_ACTION_BEGIN_BLOCK,
  end: StudyRunAction.STUDY_RUN_ACTION_END_BLOCK,
  skip: StudyRunAction.STUDY_RUN_ACTION_SKIP_BLOCK,
  repeat: StudyRunAction.STUDY_RUN_ACTION_REPEAT_BLOCK,
  note: StudyRunAction.STUDY_RUN_ACTION_NOTE,
  endRun: StudyRunAction.STUDY_RUN_ACTION_END,
  continue: StudyRunAction.STUDY_RUN_ACTION_CONTINUE,
} as const;

/** A study with two conditions. */
export const STUDY: Init<Study> = {
  name: 'Touch',
  conditions: [{ name: 'with haptics' }, { name: 'without' }],
};

/** Asks a service that takes time, such as one that measures rates. */
export async function callAndPass(
  master: TestMaster,
  init: Init<ServiceRequest>,
  passMs: number,
): Promise<ServiceReply> {
  const bytes = encode('ubii.services.ServiceRequest', init);
  const request = decode('ubii.services.ServiceRequest', bytes);
  const answer = master.master.handleServiceRequest(request, TRUSTED_CALLER);
  await master.pass(passMs);
  return (await answer).reply as ServiceReply;
}

/** Saves a study. @throws Error with the master's message when it refuses */
export async function save(master: TestMaster, study: Init<Study> = {}): Promise<Study> {
  const reply = await master.call({
    topic: `${SERVICES}study_save`,
    study: { ...STUDY, ...study },
  });
  return required(reply, 'study');
}

/** Starts a run. @throws Error with the master's message when it refuses */
export async function startRun(
  master: TestMaster,
  studyId: string,
  participantCode = 'P01',
  visit = '',
): Promise<StudyRun> {
  const studyRunStartRequest = { studyId, participantCode, visit };
  const reply = await master.call({ topic: `${SERVICES}study_run_start`, studyRunStartRequest });
  return required(reply, 'studyRun');
}

/** Changes a run. @throws Error with the master's message when it refuses */
export async function change(
  master: TestMaster,
  runId: string,
  what: keyof typeof ACTION,
  more: Init<StudyRunChangeRequest> = {},
): Promise<StudyRun> {
  const reply = await master.call({
    topic: `${SERVICES}study_run_change`,
    studyRunChangeRequest: { runId, action: ACTION[what], ...more },
  });
  return required(reply, 'studyRun');
}

/** Recordings of the master. */
export async function recordingsOf(master: TestMaster) {
  const { recordingList } = await master.call({ topic: `${SERVICES}recording_list` });
  return recordingList!.elements;
}

/** The payload of a reply. @throws Error with the master's message when it refuses */
export function required<M extends keyof ServiceReply>(
  reply: ServiceReply,
  member: M,
): NonNullable<ServiceReply[M]> {
  const { error, [member]: payload } = reply;
  if (payload === undefined || payload === null) throw new Error(error?.message ?? 'no reply');
  return payload;
}
