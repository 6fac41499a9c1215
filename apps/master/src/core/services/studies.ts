import { StudyRunAction, type StudyRunChangeRequest } from '@ubii/proto';
import { grantOf, type Caller } from '../access/caller.ts';
import { fileMakerOf, mayUseFilesOf, requireFilesOf } from '../access/file-maker.ts';
import { ADMINS, PARTICIPANTS } from '../access/roles.ts';
import type { Core } from '../areas/core.ts';
import { nameOfCaller } from './by-caller.ts';
import { definer, success } from './define-service.ts';

type Context = Pick<Core, 'studies' | 'studyRuns' | 'participants' | 'clients'>;
const define = definer<keyof Context>();

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

/** Services on studies, for their makers and admins. No entry of the audit log has a participant code. [ST-5] [ST-52] */
export const STUDY_SERVICES = [
  // [ST-1]
  define('studyList', {
    roles: PARTICIPANTS,
    handle: ({ studies }, _request, { caller }) => studies.list(usableBy(caller)),
  }),
  // [ST-1]
  define('studyGet', {
    roles: PARTICIPANTS,
    handle({ studies }, { id }, { caller }) {
      requireStudy({ studies }, id, caller);
      return studies.get(id);
    },
  }),
  // [ST-3]
  define('studySave', {
    roles: PARTICIPANTS,
    auditObject: (_core, { name }) => name,
    handle({ studies }, study, { caller }) {
      if (study.id !== '') requireStudy({ studies }, study.id, caller);
      return studies.save(study, fileMakerOf(caller));
    },
  }),
  // [ST-4]
  define('studyDelete', {
    ...STUDY,
    async handle({ studies }, { id }, { caller }) {
      requireStudy({ studies }, id, caller);
      await studies.delete(id);
      return success('The study is deleted.');
    },
  }),
  // [ST-32]
  define('studyCheck', {
    roles: PARTICIPANTS,
    handle({ studies }, { id }, { caller }) {
      requireStudy({ studies }, id, caller);
      return studies.check(id);
    },
  }),
  // [ST-20]
  define('studyRunStart', {
    roles: PARTICIPANTS,
    subject: ({ clientId }) => clientId,
    auditObject: (core, { studyId: id }) => nameOfStudy(core, { id }),
    handle({ studies, studyRuns }, request, { caller }) {
      requireStudy({ studies }, request.studyId, caller);
      return studyRuns.start(request);
    },
  }),
  // [ST-21] to [ST-25]
  define('studyRunChange', {
    roles: PARTICIPANTS,
    subject: ({ clientId }) => clientId,
    auditObject: nameOfChange,
    handle(core, request, { caller }) {
      requireRun(core, request.runId, caller);
      const author = nameOfCaller(core, request.clientId);
      return core.studyRuns.change(request, { author, grantId: grantOf(caller) });
    },
  }),
  // [ST-20]
  define('studyRunGet', {
    roles: PARTICIPANTS,
    handle({ studyRuns }, { id }, { caller }) {
      requireRun({ studyRuns }, id, caller);
      return studyRuns.get(id);
    },
  }),
  // [ST-20]
  define('studyRunList', {
    roles: PARTICIPANTS,
    handle: ({ studyRuns }, request, { caller }) => studyRuns.list(request, usableBy(caller)),
  }),
  // [ST-50]
  define('studyParticipantList', {
    roles: PARTICIPANTS,
    handle: ({ participants }, request, { caller }) => participants.list(request, usableBy(caller)),
  }),
  // [ST-51] [ST-52]
  define('studyParticipantDelete', {
    roles: ADMINS,
    auditObject: (core, { studyId: id }) => (id === '' ? 'all studies' : nameOfStudy(core, { id })),
    handle: ({ participants }, request) => participants.delete(request),
  }),
];

function usableBy(caller: Caller): (makerId: string) => boolean {
  return (makerId) => mayUseFilesOf(makerId, caller);
}

/** @throws ServiceError when there is no such study, or it is of others and the caller no admin [ST-5] */
function requireStudy({ studies }: Pick<Core, 'studies'>, id: string, caller: Caller): void {
  requireFilesOf(studies.makerOf(id), caller, 'studies');
}

/** The same for a run. */
function requireRun({ studyRuns }: Pick<Core, 'studyRuns'>, id: string, caller: Caller): void {
  requireFilesOf(studyRuns.makerOf(id), caller, 'studies');
}

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
