import {
  ServiceError,
  StudyBlockState,
  StudyRunAction,
  StudyRunState,
  type Study,
  type StudyBlock,
  type StudyRun,
  type StudyRunChangeRequest,
  type StudyRunList,
  type StudyRunListRequest,
  type StudyRunStartRequest,
} from '@ubii/proto';
import { orderOfConditions } from '@ubii/recording/studies';
import type { Clock } from '@ubii/timing';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { IdSource } from '../ports/id-source.ts';
import { isSameCode, requireLabel } from './labels.ts';
import { addNote, blockIndex, changeBlock, requireOpen, runningBlock } from './run-changes.ts';
import type { StudyBlocks, StudyLeader } from './study-blocks.ts';
import type { StudyNews } from './study-news.ts';
import type { StudyStore } from './study-store.ts';
import type { Turns } from './turns.ts';

/** What runs work with. */
export interface RunsContext {
  readonly clock: Clock;
  readonly ids: IdSource;
  readonly limits: LimitWatch;
  readonly store: StudyStore;
  readonly blocks: StudyBlocks;
  readonly news: StudyNews;
  readonly turns: Turns;
}

/** Changes a run; the result is saved unless it is the one in the store. */
type Change = (
  runs: RunsContext,
  run: StudyRun,
  request: StudyRunChangeRequest,
  by: StudyLeader,
) => StudyRun | Promise<StudyRun>;

const OPEN = StudyRunState.STUDY_RUN_STATE_OPEN;
const ENDED = StudyRunState.STUDY_RUN_STATE_ENDED;

/** What can be done with a run. [ST-21] to [ST-25] */
const CHANGES: { readonly [A in StudyRunAction]?: Change } = {
  [StudyRunAction.STUDY_RUN_ACTION_CONSENT]: consent,
  [StudyRunAction.STUDY_RUN_ACTION_BEGIN_BLOCK]: ({ blocks }, run, { block, isForced }, by) => {
    requireOpen(run);
    return blocks.begin(run, blockIndex(run, block), isForced, by);
  },
  [StudyRunAction.STUDY_RUN_ACTION_END_BLOCK]: ({ blocks }, run) => {
    if (runningBlock(run) !== undefined) return blocks.end(run);
    throw new ServiceError('failed_precondition', 'No block of the run is running.');
  },
  [StudyRunAction.STUDY_RUN_ACTION_SKIP_BLOCK]: (_runs, run, { block }) => {
    requireOpen(run);
    return changeBlock(run, blockIndex(run, block), 'skip');
  },
  [StudyRunAction.STUDY_RUN_ACTION_REPEAT_BLOCK]: (_runs, run, { block }) => {
    requireOpen(run);
    return changeBlock(run, blockIndex(run, block), 'repeat');
  },
  [StudyRunAction.STUDY_RUN_ACTION_NOTE]: note,
  [StudyRunAction.STUDY_RUN_ACTION_END]: async ({ blocks, clock }, run) => ({
    ...(await blocks.end(run)),
    state: ENDED,
    endedMs: clock.nowMs(),
  }),
  [StudyRunAction.STUDY_RUN_ACTION_CONTINUE]: (runs, run) => {
    requireNoOther(runs, run);
    return { ...run, state: OPEN, endedMs: 0 };
  },
};

/** Runs of studies. [ST-20] to [ST-25] */
export class StudyRuns {
  readonly #context: RunsContext;

  constructor(context: RunsContext) {
    this.#context = context;
  }

  /** @param isWanted whether runs of studies of this maker are listed [ST-5] */
  list(
    { studyId, participantCode }: StudyRunListRequest,
    isWanted: (makerId: string) => boolean,
  ): StudyRunList {
    const { store } = this.#context;
    const elements = store
      .runs(studyId)
      .filter((run) => participantCode === '' || isSameCode(run.participantCode, participantCode))
      .filter((run) => isWanted(store.makerOf(run.studyId)));
    return { elements };
  }

  /** Whose a run is: that of its study. [ST-5] @throws ServiceError when there is none of this id */
  makerOf(id: string): string {
    const { store } = this.#context;
    return store.makerOf(store.requireRun(id).studyId);
  }

  get(id: string): StudyRun {
    return this.#context.store.requireRun(id);
  }

  find(id: string): StudyRun | undefined {
    return this.#context.store.runs().find((run) => run.id === id);
  }

  /** [ST-20] */
  start({ studyId, participantCode, visit }: StudyRunStartRequest): Promise<StudyRun> {
    const { store, turns, ids, clock } = this.#context;
    requireLabel('participant_code', participantCode);
    const wanted = { studyId, visit: requireLabel('visit', visit === '' ? '1' : visit) };
    return turns.run(async () => {
      const study = store.require(studyId);
      const who = this.#participant(studyId, participantCode);
      const id = ids.uuid();
      requireNoOther(this.#context, { ...wanted, ...who, id });
      const run: StudyRun = {
        ...wanted,
        ...who,
        id,
        state: OPEN,
        revision: 0,
        startedMs: clock.nowMs(),
        endedMs: 0,
        blocks: blocksOf(study, who.participantNumber, wanted.visit),
        consent: undefined,
        notes: [],
      };
      return this.#save(run);
    });
  }

  /** [ST-21] to [ST-25] */
  change(request: StudyRunChangeRequest, by: StudyLeader): Promise<StudyRun> {
    const change = CHANGES[request.action];
    if (change === undefined) {
      throw new ServiceError('invalid_argument', `The action ${request.action} is not known.`);
    }
    return this.#context.turns.run(async () => {
      const run = this.#context.store.requireRun(request.runId);
      return this.#save(await change(this.#context, run, request, by));
    });
  }

  /** The duration of the block with this recording is over. [ST-23] */
  endBlock(runId: string, recordingId: string): Promise<void> {
    const { turns, blocks } = this.#context;
    return turns.run(async () => {
      // Meanwhile, the block may have been ended, or the run deleted.
      const run = this.find(runId);
      const index = run && runningBlock(run);
      const take = index === undefined ? undefined : run?.blocks[index]?.takes.at(-1);
      if (run !== undefined && take?.recordingId === recordingId) {
        await this.#save(await blocks.end(run));
      }
    });
  }

  async #save(run: StudyRun): Promise<StudyRun> {
    const { store, news } = this.#context;
    const saved = { ...run, revision: run.revision + 1 };
    await store.saveRun(saved);
    news.announce();
    return saved;
  }

  /** A known participant, or a new one with the lowest free number. [ST-11] */
  #participant(
    studyId: string,
    code: string,
  ): Pick<StudyRun, 'participantCode' | 'participantNumber'> {
    const runs = this.#context.store.runs(studyId);
    const known = runs.find(({ participantCode }) => isSameCode(participantCode, code));
    if (known !== undefined) {
      const { participantCode, participantNumber } = known;
      return { participantCode, participantNumber };
    }
    const numbers = new Set(runs.map(({ participantNumber }) => participantNumber));
    let number = 1;
    while (numbers.has(number)) number++;
    return { participantCode: code, participantNumber: number };
  }
}

/** [ST-10] */
function blocksOf(
  { id, conditions, order, repetitions }: Study,
  number: number,
  visit: string,
): StudyBlock[] {
  const subject = { studyId: id, number, visit };
  return Array.from({ length: repetitions }, (_, index) => index + 1).flatMap((repetition) =>
    orderOfConditions(order, conditions.length, repetition, subject).map((place) => {
      const { name, sessionId } = conditions[place]!;
      const state = StudyBlockState.STUDY_BLOCK_STATE_PENDING;
      return { condition: name, repetition, sessionId, state, takes: [] };
    }),
  );
}

/** @throws ServiceError when another run is in the way [ST-20] */
function requireNoOther(
  { store, limits }: RunsContext,
  run: Pick<StudyRun, 'id' | 'studyId' | 'participantCode' | 'visit'>,
): void {
  const others = store.runs().filter(({ id, state }) => id !== run.id && state !== ENDED);
  const isSame = others.some(
    ({ studyId, participantCode, visit }) =>
      studyId === run.studyId &&
      isSameCode(participantCode, run.participantCode) &&
      isSameCode(visit, run.visit),
  );
  if (isSame) {
    throw new ServiceError(
      'already_exists',
      'A run of this participant and visit is not ended. Continue or end it, or choose another visit.',
    );
  }
  const max = limits.limits.openStudyRuns;
  if (others.filter(({ state }) => state === OPEN).length >= max) {
    throw limits.refusal('openStudyRuns', `more than ${max} open runs of studies`);
  }
}

/** [ST-22] */
function consent(
  { store, clock }: RunsContext,
  run: StudyRun,
  { consentVersion }: StudyRunChangeRequest,
  { author }: StudyLeader,
): StudyRun {
  requireOpen(run);
  const study = store.require(run.studyId);
  if (study.consentText === '') {
    throw new ServiceError('failed_precondition', 'The study has no consent text.');
  }
  if (consentVersion !== study.consentVersion) {
    throw new ServiceError(
      'failed_precondition',
      `The participant read version ${consentVersion} of the consent text, but the study has version ${study.consentVersion}. Show that one.`,
    );
  }
  return { ...run, consent: { version: consentVersion, timeMs: clock.nowMs(), author } };
}

/** [ST-24] */
async function note(
  { blocks, limits, clock }: RunsContext,
  run: StudyRun,
  { text }: StudyRunChangeRequest,
  { author }: StudyLeader,
): Promise<StudyRun> {
  const max = limits.limits.studyNotes;
  if (run.notes.length >= max)
    throw limits.refusal('studyNotes', `more than ${max} notes of a run`);
  if (text.trim() === '') {
    throw new ServiceError('invalid_argument', 'The note is empty. Set `text`.');
  }
  await blocks.mark(run, text, author);
  const index = runningBlock(run);
  const block = index === undefined ? 0 : index + 1;
  return addNote(run, { timeMs: clock.nowMs(), text, author, block });
}
