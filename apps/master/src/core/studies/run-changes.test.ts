import { decode, StudyBlockState, StudyRunState, type StudyRun } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import {
  beginBlock,
  blockIndex,
  changeBlock,
  endBlock,
  interrupted,
  requireStart,
  runningBlock,
  type BlockEvent,
} from './run-changes.ts';

const EMPTY_RUN = decode('ubii.extension.StudyRun', new Uint8Array());
const take = {
  recordingId: 'r',
  name: 'n',
  runNumber: 1,
  startedMs: 5,
  endedMs: 0,
  forced: '',
  problem: '',
};
const STATES = Object.values(StudyBlockState);
const EVENTS: readonly BlockEvent[] = ['begin', 'end', 'skip', 'repeat', 'interrupt'];
const { STUDY_BLOCK_STATE_PENDING: PENDING, STUDY_BLOCK_STATE_RUNNING: RUNNING } = StudyBlockState;
const { STUDY_BLOCK_STATE_DONE: DONE, STUDY_BLOCK_STATE_SKIPPED: SKIPPED } = StudyBlockState;
const INTERRUPTED = StudyBlockState.STUDY_BLOCK_STATE_INTERRUPTED;

/** A run with blocks in these states. */
function runWith(...states: StudyBlockState[]): StudyRun {
  const blocks = states.map((state) => ({
    condition: 'c',
    repetition: 1,
    sessionId: '',
    state,
    takes: [],
  }));
  return { ...EMPTY_RUN, state: StudyRunState.STUDY_RUN_STATE_OPEN, blocks };
}

const statesOf = ({ blocks }: StudyRun) => blocks.map(({ state }) => state);

describe('a block', () => {
  it('changes its state by legal moves only [ST-21]', () => {
    const moves = EVENTS.flatMap((event) =>
      STATES.flatMap((state) => {
        try {
          return [[state, event, statesOf(changeBlock(runWith(state), 0, event))[0]]];
        } catch (error) {
          expect(error).toMatchObject({ code: 'failed_precondition' });
          return [];
        }
      }),
    );
    expect(moves).toEqual([
      [PENDING, 'begin', RUNNING],
      [RUNNING, 'end', DONE],
      [PENDING, 'skip', SKIPPED],
      [INTERRUPTED, 'skip', SKIPPED],
      [DONE, 'repeat', PENDING],
      [SKIPPED, 'repeat', PENDING],
      [INTERRUPTED, 'repeat', PENDING],
      [RUNNING, 'interrupt', INTERRUPTED],
    ]);
  });

  it('is the next pending one without a number [ST-21]', () => {
    const run = runWith(DONE, SKIPPED, PENDING, PENDING);
    expect([0, 1, 4].map((number) => blockIndex(run, number))).toEqual([2, 0, 3]);
    expect(() => blockIndex(runWith(DONE), 0)).toThrow('No block of the run is pending.');
    for (const number of [5, -1]) expect(() => blockIndex(run, number)).toThrow('blocks 1 to 4');
  });

  it('does not begin while another one runs [ST-21]', () => {
    const run = runWith(DONE, RUNNING, PENDING);
    expect(runningBlock(run)).toBe(1);
    expect(() => requireStart(run, 2)).toThrow('Block 2 of the run is running.');
    expect(() => requireStart(runWith(DONE, PENDING), 0)).toThrow('Block 1 is done');
  });

  it('is done again when its repetition is skipped [ST-21]', () => {
    const skipped = (problem: string) => {
      const once = endBlock(beginBlock(runWith(PENDING), 0, take), 0, { endedMs: 9, problem });
      return statesOf(changeBlock(changeBlock(once, 0, 'repeat'), 0, 'skip'));
    };
    expect([skipped(''), skipped('The disk is full.')]).toEqual([[DONE], [SKIPPED]]);
  });

  it('keeps the recordings of each time it was done [ST-21]', () => {
    const once = endBlock(beginBlock(runWith(PENDING), 0, take), 0, { endedMs: 9, problem: '' });
    const again = beginBlock(changeBlock(once, 0, 'repeat'), 0, { ...take, recordingId: 's' });
    const ended = endBlock(again, 0, { endedMs: 12, problem: 'cut' });
    expect(ended.blocks[0]!.takes).toMatchObject([
      { recordingId: 'r', endedMs: 9, problem: '' },
      { recordingId: 's', endedMs: 12, problem: 'cut' },
    ]);
  });
});

describe('a run that was open when its master exited', () => {
  it('is interrupted, and so is its running block [ST-25]', () => {
    const run = interrupted(beginBlock(runWith(DONE, PENDING), 1, take));
    expect(run.state).toBe(StudyRunState.STUDY_RUN_STATE_INTERRUPTED);
    expect(statesOf(run)).toEqual([DONE, INTERRUPTED]);
    expect(run.blocks[1]!.takes).toMatchObject([
      { endedMs: 0, problem: expect.stringContaining('exited') as string },
    ]);
    expect(statesOf(changeBlock(run, 1, 'repeat'))).toEqual([DONE, PENDING]);
  });

  it('stays ended when it was ended [ST-25]', () => {
    const ended = { ...runWith(DONE), state: StudyRunState.STUDY_RUN_STATE_ENDED };
    expect(interrupted(ended)).toBe(ended);
  });
});
