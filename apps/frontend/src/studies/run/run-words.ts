import {
  StudyBlockState,
  StudyCheckKind,
  StudyCheckState,
  StudyRunState,
  type StudyBlock,
  type StudyCheckItem,
  type StudyCheckList,
  type StudyCheckRow,
  type StudyRun,
} from '@ubii/proto';
import { counted } from '@ubii/words';
import type { MarkedState } from '../../ui/UiStateMark.vue';

/** A state as a mark and a word. */
export interface Look {
  readonly mark: MarkedState;
  readonly word: string;
}

const BLOCKS: Readonly<Record<StudyBlockState, Look>> = {
  [StudyBlockState.STUDY_BLOCK_STATE_PENDING]: { mark: 'stopped', word: 'To do' },
  [StudyBlockState.STUDY_BLOCK_STATE_RUNNING]: { mark: 'live', word: 'Running' },
  [StudyBlockState.STUDY_BLOCK_STATE_DONE]: { mark: 'live', word: 'Done' },
  [StudyBlockState.STUDY_BLOCK_STATE_SKIPPED]: { mark: 'away', word: 'Skipped' },
  [StudyBlockState.STUDY_BLOCK_STATE_INTERRUPTED]: { mark: 'warning', word: 'Interrupted' },
};
export function blockLook({ state, takes }: StudyBlock): Look {
  if (state === StudyBlockState.STUDY_BLOCK_STATE_PENDING && takes.length > 0)
    return { mark: 'stopped', word: 'To repeat' };
  return BLOCKS[state] ?? { mark: 'warning', word: 'Unknown' };
}

const CHECKS: Readonly<Record<StudyCheckState, Look>> = {
  [StudyCheckState.STUDY_CHECK_STATE_OK]: { mark: 'live', word: 'Ready' },
  [StudyCheckState.STUDY_CHECK_STATE_MISSING]: { mark: 'error', word: 'Missing' },
  [StudyCheckState.STUDY_CHECK_STATE_LOW]: { mark: 'error', word: 'Too low' },
};
export const checkLook = (state: StudyCheckState): Look =>
  CHECKS[state] ?? { mark: 'error', word: 'Unknown' };

const KINDS: Readonly<Record<StudyCheckKind, string>> = {
  [StudyCheckKind.STUDY_CHECK_KIND_PRESENCE]: 'Connected',
  [StudyCheckKind.STUDY_CHECK_KIND_RATE]: 'Rate',
  [StudyCheckKind.STUDY_CHECK_KIND_BATTERY]: 'Battery',
  [StudyCheckKind.STUDY_CHECK_KIND_CLOCK]: 'Clock error',
};
export const checkWord = ({ kind }: StudyCheckItem): string => KINDS[kind] ?? 'Check';

const isOk = ({ state }: { readonly state: StudyCheckState }): boolean =>
  state === StudyCheckState.STUDY_CHECK_STATE_OK;

/** What to do about the first thing that is wrong with a device; undefined when nothing is. */
export function adviceOf({ items }: StudyCheckRow): string | undefined {
  const item = items.find((one) => !isOk(one));
  if (item === undefined) return undefined;
  const isMissing = item.state === StudyCheckState.STUDY_CHECK_STATE_MISSING;
  switch (item.kind) {
    case StudyCheckKind.STUDY_CHECK_KIND_PRESENCE:
      return 'Connect the device. On a phone, open Smart device and use it once.';
    case StudyCheckKind.STUDY_CHECK_KIND_RATE:
      return 'Use the device, keep its page open, and check its Wi-Fi.';
    case StudyCheckKind.STUDY_CHECK_KIND_BATTERY:
      return isMissing
        ? 'The device does not report its battery. Remove the requirement, or use another browser.'
        : 'Charge the device.';
    case StudyCheckKind.STUDY_CHECK_KIND_CLOCK:
      return isMissing
        ? 'The device has not measured its clock yet. Wait, or reload its page.'
        : 'Wait until the clock is measured again, or check the Wi-Fi of the device.';
    default:
      return undefined;
  }
}

/** Whether a phone that joins could help. */
export const isAbsent = ({ items }: StudyCheckRow): boolean =>
  items.some((one) => one.kind === StudyCheckKind.STUDY_CHECK_KIND_PRESENCE && !isOk(one));

/** The check list in one sentence, which changes only when a state does. */
export function checkSentence({ rows }: StudyCheckList): string {
  if (rows.length === 0) return 'This study requires no device.';
  const bad = rows.filter((row) => !isOk(row));
  if (bad.length === 0) return 'All devices are ready.';
  const names = bad.map(({ name, state }) => `${name} (${checkLook(state).word.toLowerCase()})`);
  return `Not ready: ${names.join(', ')}.`;
}

/** `Block 2 of 4`. */
export const blockPlace = (number: number, { blocks }: StudyRun): string =>
  `Block ${number} of ${blocks.length}`;

/** Condition of a block, with the repetition where there are several. */
export function blockTitle({ condition, repetition }: StudyBlock, { blocks }: StudyRun): string {
  const isRepeated = blocks.some((block) => block.repetition > 1);
  return isRepeated ? `${condition}, repetition ${repetition}` : condition;
}

const isLeft = ({ state }: StudyBlock): boolean =>
  state === StudyBlockState.STUDY_BLOCK_STATE_PENDING ||
  state === StudyBlockState.STUDY_BLOCK_STATE_INTERRUPTED;

/** The state of a run with a participant, one sentence for those who took part. */
export function endSentence({ participantCode, blocks }: StudyRun): string {
  return blocks.some(isLeft)
    ? `The run of ${participantCode} ended early.`
    : `${participantCode} is done.`;
}

/** What is open in a run, with a space after it; empty for a run that ended with its last block. */
export function runStateWords(run: StudyRun): string {
  if (run.state === StudyRunState.STUDY_RUN_STATE_OPEN) return 'Open. ';
  if (run.state === StudyRunState.STUDY_RUN_STATE_INTERRUPTED) return 'Interrupted. ';
  return run.blocks.some(isLeft) ? 'Ended early. ' : '';
}

/** What a run made, in one sentence. */
export function runSummary({ blocks }: StudyRun): string {
  const count = (state: StudyBlockState): number =>
    blocks.filter((block) => block.state === state).length;
  const done = count(StudyBlockState.STUDY_BLOCK_STATE_DONE);
  const skipped = count(StudyBlockState.STUDY_BLOCK_STATE_SKIPPED);
  const files = blocks.flatMap(({ takes }) => takes).length;
  const rest = skipped > 0 ? `, ${skipped} skipped` : '';
  return `${done} of ${counted(blocks.length, 'block')} done${rest}, ${counted(files, 'recording')}.`;
}
