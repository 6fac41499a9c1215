import { StudyBlockState, StudyRunState, type StudyBlock, type StudyRun } from '@ubii/proto';

/** What is to be done next in a run. */
export type RunStage =
  | 'consent'
  | 'ready'
  | 'running'
  /** No block is left but those that were interrupted. */
  | 'incomplete'
  | 'done'
  | 'interrupted'
  | 'ended';

const is = (state: StudyBlockState) => (block: StudyBlock) => block.state === state;
const isPending = is(StudyBlockState.STUDY_BLOCK_STATE_PENDING);
const isRunning = is(StudyBlockState.STUDY_BLOCK_STATE_RUNNING);

/** Number of the block that runs, from 1; 0 for none. */
export const runningNumber = ({ blocks }: StudyRun): number => blocks.findIndex(isRunning) + 1;

/** Number of the block that comes next, from 1; 0 for none. */
export const nextNumber = ({ blocks }: StudyRun): number => blocks.findIndex(isPending) + 1;

/** Number of the first block that was interrupted, from 1; 0 for none. */
export const interruptedNumber = ({ blocks }: StudyRun): number =>
  blocks.findIndex(is(StudyBlockState.STUDY_BLOCK_STATE_INTERRUPTED)) + 1;

/** Number of the block that runs or comes next, from 1; 0 for none. */
export const currentNumber = (run: StudyRun): number => runningNumber(run) || nextNumber(run);

/** @param needsConsent whether the study has a text to consent to */
export function runStage(run: StudyRun, needsConsent: boolean): RunStage {
  if (run.state === StudyRunState.STUDY_RUN_STATE_ENDED) return 'ended';
  if (run.state === StudyRunState.STUDY_RUN_STATE_INTERRUPTED) return 'interrupted';
  if (runningNumber(run) > 0) return 'running';
  if (nextNumber(run) === 0) return interruptedNumber(run) > 0 ? 'incomplete' : 'done';
  return needsConsent && run.consent === undefined ? 'consent' : 'ready';
}

/** Blocks that are done or skipped. */
export const finishedCount = ({ blocks }: StudyRun): number =>
  blocks.filter(
    ({ state }) =>
      state === StudyBlockState.STUDY_BLOCK_STATE_DONE ||
      state === StudyBlockState.STUDY_BLOCK_STATE_SKIPPED,
  ).length;
