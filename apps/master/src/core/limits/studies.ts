import { limit } from './limit.ts';

/** Limits of studies and their runs. */
export const STUDY_LIMITS = {
  studies: limit(100, 'studies', 'storage', 'Studies that are kept. All are in memory.'),
  studyRuns: limit(
    1_000,
    'runs',
    'storage',
    'Runs of one study. All are in memory, with blocks and notes.',
  ),
  studyConditions: limit(32, 'conditions', 'storage', 'Conditions of one study.'),
  studyDevices: limit(
    32,
    'devices',
    'storage',
    'Required devices of one study. Each is compared with all topics each second.',
  ),
  studyBlocks: limit(200, 'blocks', 'storage', 'Blocks of a run: conditions times repetitions.'),
  studyTakes: limit(500, 'recordings', 'storage', 'Recordings of one run.'),
  studyNotes: limit(500, 'notes', 'storage', 'Notes of one run.'),
  studyConsentTexts: limit(
    50,
    'texts',
    'storage',
    'Versions of the consent text of one study that participants consented to.',
  ),
  openStudyRuns: limit(8, 'runs', 'storage', 'Runs that are open at the same time.'),
  studyChecks: limit(
    8,
    'studies',
    'rates',
    'Studies whose required devices are checked each second because a page shows them.',
  ),
  consentCharacters: limit(20_000, 'characters', 'texts', 'Consent text of a study, ten pages.'),
  nameTemplateCharacters: limit(
    200,
    'characters',
    'texts',
    'Template of the names of recordings of a study.',
  ),
} as const;
