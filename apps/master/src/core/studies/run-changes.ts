import {
  ServiceError,
  StudyBlockState,
  StudyRunState,
  type StudyBlock,
  type StudyNote,
  type StudyRun,
  type StudyTake,
} from '@ubii/proto';

const { STUDY_BLOCK_STATE_PENDING: PENDING, STUDY_BLOCK_STATE_RUNNING: RUNNING } = StudyBlockState;
const { STUDY_BLOCK_STATE_DONE: DONE, STUDY_BLOCK_STATE_SKIPPED: SKIPPED } = StudyBlockState;
const INTERRUPTED = StudyBlockState.STUDY_BLOCK_STATE_INTERRUPTED;

/** What happens to a block. */
export type BlockEvent = 'begin' | 'end' | 'skip' | 'repeat' | 'interrupt';

/** Every legal move. [ST-21] */
const MOVES: { readonly [E in BlockEvent]: { readonly [S in StudyBlockState]?: StudyBlockState } } =
  {
    begin: { [PENDING]: RUNNING },
    end: { [RUNNING]: DONE },
    skip: { [PENDING]: SKIPPED, [INTERRUPTED]: SKIPPED },
    repeat: { [DONE]: PENDING, [SKIPPED]: PENDING, [INTERRUPTED]: PENDING },
    interrupt: { [RUNNING]: INTERRUPTED },
  };

const WORDS: { readonly [S in StudyBlockState]: string } = {
  [PENDING]: 'pending',
  [RUNNING]: 'running',
  [DONE]: 'done',
  [SKIPPED]: 'skipped',
  [INTERRUPTED]: 'interrupted',
};

const VERBS: { readonly [E in BlockEvent]: string } = {
  begin: 'begin',
  end: 'end',
  skip: 'be skipped',
  repeat: 'be repeated',
  interrupt: 'be interrupted',
};

/** Index of the block that runs; undefined when none does. */
export function runningBlock({ blocks }: StudyRun): number | undefined {
  const index = blocks.findIndex(({ state }) => state === RUNNING);
  return index === -1 ? undefined : index;
}

/** Index of the block that a request means. @param number from 1; 0 for the next pending one @throws ServiceError when there is none */
export function blockIndex({ blocks }: StudyRun, number: number): number {
  const index =
    number === 0 ? blocks.findIndex(({ state }) => state === PENDING) : Math.trunc(number) - 1;
  if (blocks[index] !== undefined) return index;
  throw number === 0
    ? refused('No block of the run is pending. Repeat one, or end the run.')
    : new ServiceError(
        'invalid_argument',
        `The member block is ${number}, but the run has blocks 1 to ${blocks.length}.`,
      );
}

/** @throws ServiceError unless blocks of the run may begin [ST-21] */
export function requireOpen({ state }: StudyRun): void {
  if (state === StudyRunState.STUDY_RUN_STATE_OPEN) return;
  throw refused('The run is not open. Continue it first.');
}

/** @throws ServiceError when the block may not begin [ST-21] */
export function requireStart(run: StudyRun, index: number): void {
  const running = runningBlock(run);
  if (running !== undefined) {
    throw refused(`Block ${running + 1} of the run is running. End it first.`);
  }
  move(run.blocks[index]!, index, 'begin');
}

/** @throws ServiceError when the block is in no state for it [ST-21] */
export function changeBlock(run: StudyRun, index: number, event: BlockEvent): StudyRun {
  return withBlock(run, index, (block) => {
    const state = move(block, index, event);
    return { ...block, state: state === SKIPPED && wasDone(block) ? DONE : state };
  });
}

/** Whether a recording is of the whole block: a repetition that is skipped leaves the block done. */
const wasDone = ({ takes }: StudyBlock): boolean =>
  takes.some(({ endedMs, problem }) => endedMs > 0 && problem === '');

export function beginBlock(run: StudyRun, index: number, take: StudyTake): StudyRun {
  const begun = changeBlock(run, index, 'begin');
  return withBlock(begun, index, (block) => ({ ...block, takes: [...block.takes, take] }));
}

/** Ends a block; its last recording has ended then, too. */
export function endBlock(
  run: StudyRun,
  index: number,
  end: Pick<StudyTake, 'endedMs' | 'problem'>,
): StudyRun {
  return withLastTake(changeBlock(run, index, 'end'), index, end);
}

export function addNote(run: StudyRun, note: StudyNote): StudyRun {
  return { ...run, notes: [...run.notes, note] };
}

/** A run as it is after the master that held it exited. [ST-25] */
export function interrupted(run: StudyRun): StudyRun {
  if (run.state !== StudyRunState.STUDY_RUN_STATE_OPEN) return run;
  const state = StudyRunState.STUDY_RUN_STATE_INTERRUPTED;
  const stopped = { ...run, state, revision: run.revision + 1 };
  const index = runningBlock(run);
  if (index === undefined) return stopped;
  const problem = 'The master exited while the block ran.';
  return withLastTake(changeBlock(stopped, index, 'interrupt'), index, { problem });
}

function move({ state }: StudyBlock, index: number, event: BlockEvent): StudyBlockState {
  const next = MOVES[event][state];
  if (next !== undefined) return next;
  throw refused(`Block ${index + 1} is ${WORDS[state]}, so it cannot ${VERBS[event]}.`);
}

function withBlock(
  run: StudyRun,
  index: number,
  change: (block: StudyBlock) => StudyBlock,
): StudyRun {
  return { ...run, blocks: run.blocks.map((each, i) => (i === index ? change(each) : each)) };
}

function withLastTake(run: StudyRun, index: number, change: Partial<StudyTake>): StudyRun {
  return withBlock(run, index, (block) => ({
    ...block,
    takes: block.takes.map((take, i) =>
      i === block.takes.length - 1 ? { ...take, ...change } : take,
    ),
  }));
}

function refused(text: string): ServiceError {
  return new ServiceError('failed_precondition', text);
}
