import type { HowTo } from './how-to.ts';
import { PROGRAM_HOW_TOS } from './programs.ts';
import { RECORDING_HOW_TOS } from './recordings.ts';
import { REPLAY_HOW_TOS } from './replays.ts';
import { STUDY_HOW_TOS } from './studies.ts';

/** All how-tos, in the order of the contents. */
export const HOW_TOS: readonly HowTo[] = [
  ...PROGRAM_HOW_TOS,
  ...RECORDING_HOW_TOS,
  ...REPLAY_HOW_TOS,
  ...STUDY_HOW_TOS,
];
