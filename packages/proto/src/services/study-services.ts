import { withoutPayload, withPayload } from './define-service.ts';

/** Services on studies, their runs and participants. [ST-1] to [ST-51] */
export const STUDY_SERVICES = {
  studyList: withoutPayload(
    '/services/ubii/study_list',
    'studyList',
    'Lists the studies with the numbers of their participants and runs.',
  ),
  studyGet: withPayload(
    '/services/ubii/study_get',
    'studyRequest',
    'study',
    'Returns a study with its texts.',
  ),
  studySave: withPayload(
    '/services/ubii/study_save',
    'study',
    'study',
    'Creates a study, or replaces one that no other client has changed since.',
  ),
  studyDelete: withPayload(
    '/services/ubii/study_delete',
    'studyRequest',
    'success',
    'Deletes a study that has no participants.',
  ),
  studyCheck: withPayload(
    '/services/ubii/study_check',
    'studyRequest',
    'studyCheckList',
    'Checks the required devices of a study, and publishes the check list each second for ten seconds.',
  ),
  studyRunStart: withPayload(
    '/services/ubii/study_run_start',
    'studyRunStartRequest',
    'studyRun',
    'Starts a run of a study with a participant, with its blocks in order.',
  ),
  studyRunChange: withPayload(
    '/services/ubii/study_run_change',
    'studyRunChangeRequest',
    'studyRun',
    'Confirms consent, begins, ends, skips or repeats a block, adds a note, ends or continues a run.',
  ),
  studyRunGet: withPayload(
    '/services/ubii/study_run_get',
    'studyRunRequest',
    'studyRun',
    'Returns a run with its blocks, recordings and notes.',
  ),
  studyRunList: withPayload(
    '/services/ubii/study_run_list',
    'studyRunListRequest',
    'studyRunList',
    'Lists the runs of a study or of a participant.',
  ),
  studyParticipantList: withPayload(
    '/services/ubii/study_participant_list',
    'studyParticipantRequest',
    'studyParticipantList',
    'Lists participants with their runs and recordings.',
  ),
  studyParticipantDelete: withPayload(
    '/services/ubii/study_participant_delete',
    'studyParticipantRequest',
    'studyDeletion',
    'Deletes all recordings, runs and notes of a participant.',
  ),
} as const;
