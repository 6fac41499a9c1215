import { StudyRunAction, type StudyRunChangeRequest } from '@ubii/proto';
import { makerOf } from '../access/caller.ts';
import { ADMINS, PARTICIPANTS } from '../access/roles.ts';
import type { Core } from '../areas/core.ts';
import { nameOfCaller } from './by-caller.ts';
import { definer, success } from './define-service.ts';

type Parts = Pick<Core, 'studies' | 'studyRuns' | 'participants' | 'clients'>;
const define = definer<keyof Parts>();

const STUDY = { roles: PARTICIPANTS, auditObject: nameOfStudy };

/** What an action is called in the audit log. */
const WORDS: { readonly [A in StudyRunAction]?: string } = {
  [StudyRunAction.STUDY_RUN_ACTION_CONSENT]: 'consent',
  [StudyRunAction.STUDY_RUN_ACTION_BEGIN_BLOCK]: 'begin block',
  [StudyRunAction.STUDY_RUN_ACTION_END_BLOCK]: 'end block',
  [StudyRunAction.STUDY_RUN_ACTION_SKIP_BLOCK]: 'skip block',
  [StudyRunAction.STUDY_RUN_ACTION_REPEAT_BLOCK]: 'repeat block',
  [StudyRunAction.STUDY_RUN_ACTION_NOTE]: 'note',
  [StudyRunAction.STUDY_RUN_ACTION_END]: 'end run',
  [StudyRunAction.STUDY_RUN_ACTION_CONTINUE]: 'continue run',
};

/** Services on studies. No entry of the audit log has a participant code. [ST-5] [ST-52] */
export const STUDY_SERVICES = [
  // [ST-1]
  define('studyList', { roles: PARTICIPANTS, handle: ({ studies }) => studies.list() }),
  // [ST-1]
  define('studyGet', {
    roles: PARTICIPANTS,
    handle: ({ studies }, { id }) => studies.get(id),
  }),
  // [ST-3]
  define('studySave', {
    roles: PARTICIPANTS,
    auditObject: (_core, { name }) => name,
    handle: ({ studies }, study) => studies.save(study),
  }),
  // [ST-4]
  define('studyDelete', {
    ...STUDY,
    async handle({ studies }, { id }) {
      await studies.delete(id);
      return success('The study is deleted.');
    },
  }),
  // [ST-32]
  define('studyCheck', {
    roles: PARTICIPANTS,
    handle: ({ studies }, { id }) => studies.check(id),
  }),
  // [ST-20]
  define('studyRunStart', {
    roles: PARTICIPANTS,
    subject: ({ clientId }) => clientId,
    auditObject: (core, { studyId: id }) => nameOfStudy(core, { id }),
    handle: ({ studyRuns }, request) => studyRuns.start(request),
  }),
  // [ST-21] to [ST-25]
  define('studyRunChange', {
    roles: PARTICIPANTS,
    subject: ({ clientId }) => clientId,
    auditObject: nameOfChange,
    handle(core, request, { caller }) {
      const author = nameOfCaller(core, request.clientId);
      return core.studyRuns.change(request, { author, makerId: makerOf(caller) });
    },
  }),
  // [ST-20]
  define('studyRunGet', {
    roles: PARTICIPANTS,
    handle: ({ studyRuns }, { id }) => studyRuns.get(id),
  }),
  // [ST-20]
  define('studyRunList', {
    roles: PARTICIPANTS,
    handle: ({ studyRuns }, request) => studyRuns.list(request),
  }),
  // [ST-50]
  define('studyParticipantList', {
    roles: PARTICIPANTS,
    handle: ({ participants }, request) => participants.list(request),
  }),
  // [ST-51] [ST-52]
  define('studyParticipantDelete', {
    roles: ADMINS,
    auditObject: (core, { studyId: id }) => (id === '' ? 'all studies' : nameOfStudy(core, { id })),
    handle: ({ participants }, request) => participants.delete(request),
  }),
];

function nameOfStudy({ studies }: Pick<Core, 'studies'>, { id }: { readonly id: string }): string {
  return studies.nameOf(id);
}

function nameOfChange(
  { studies, studyRuns }: Pick<Core, 'studies' | 'studyRuns'>,
  { runId, action }: StudyRunChangeRequest,
): string {
  const word = WORDS[action] ?? String(action);
  const studyId = studyRuns.find(runId)?.studyId;
  return studyId === undefined ? word : `${studies.nameOf(studyId)}: ${word}`;
}
