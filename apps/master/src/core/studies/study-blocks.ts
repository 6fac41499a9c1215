import {
  decode,
  ServiceError,
  StudyBlockState,
  type Recording,
  type RecordingMarker,
  type Study,
  type StudyRun,
  type StudyTake,
} from '@ubii/proto';
import { NameTemplate } from '@ubii/recording/studies';
import type { Cancel, Clock } from '@ubii/timing';
import type { GrantId } from '../access/grant.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { Recordings } from '../recordings/recordings.ts';
import { EVERYTHING } from '../recordings/selection.ts';
import type { Sessions } from '../sessions/sessions.ts';
import { troublesOf } from './check-row.ts';
import type { OwnValues } from './own-values.ts';
import { beginBlock, endBlock, requireStart, runningBlock } from './run-changes.ts';
import type { StudyChecks } from './study-checks.ts';
import type { StudyStore } from './study-store.ts';

/** What blocks work with. */
export interface BlocksContext {
  readonly clock: Clock;
  readonly limits: LimitWatch;
  readonly store: StudyStore;
  readonly checks: StudyChecks;
  readonly ownValues: OwnValues;
  readonly recordings: Recordings;
  readonly sessions: Sessions;
  /** The duration of the block that runs is over. */
  readonly onTimeUp: (runId: string, recordingId: string) => void;
}

/** Who leads a run. */
export interface StudyLeader {
  /** Name of the client; empty when none asks. */
  readonly author: string;
  /** Id of its invitation, for the sessions of blocks; empty when it needs none. [AC-90] */
  readonly grantId: GrantId | undefined;
}

const EMPTY_SESSION = decode('ubii.sessions.Session', new Uint8Array());
const EMPTY_MARKER = decode('ubii.extension.RecordingMarker', new Uint8Array());

/** Recordings and sessions of blocks. [ST-23] [ST-24] */
export class StudyBlocks {
  readonly #context: BlocksContext;
  /** Ends of blocks with a duration, by run. */
  readonly #ends = new Map<string, Cancel>();
  /** Sessions that blocks have started, by run. */
  readonly #sessions = new Map<string, string>();

  constructor(context: BlocksContext) {
    this.#context = context;
  }

  /** Begins a block, and saves the run. @throws ServiceError when it may not begin [ST-21] [ST-22] [ST-31] */
  async begin(run: StudyRun, index: number, isForced: boolean, by: StudyLeader): Promise<StudyRun> {
    const { store, clock, recordings } = this.#context;
    const study = store.require(run.studyId);
    requireStart(run, index);
    requireConsent(study, run);
    this.#requireRoom(run);
    const forced = await this.#checkDevices(study, isForced);
    const { sessionId, condition } = run.blocks[index]!;
    // Before anything is started: a session that is not there starts nothing.
    if (sessionId !== '') await this.#context.sessions.find(sessionId);
    const { recording, runNumber } = await this.#record(study, run, index, forced, by);
    try {
      await this.#startSession(run.id, sessionId, by.grantId);
      const startedMs = clock.nowMs();
      const take = {
        recordingId: recording.id,
        name: recording.name,
        runNumber,
        startedMs,
        forced,
      };
      const begun = beginBlock(run, index, { ...take, endedMs: 0, problem: '' });
      await store.saveRun(begun);
      await this.mark(begun, `Begin of block ${index + 1}: ${condition}`, by.author);
      this.#endAfter(run.id, recording.id, study.blockMs);
      return begun;
    } catch (cause) {
      this.abandon(run);
      await recordings.delete(recording.id);
      throw cause;
    }
  }

  /** Ends the block that runs, if there is one. Its run is not saved yet. */
  async end(run: StudyRun): Promise<StudyRun> {
    const index = runningBlock(run);
    if (index === undefined) return run;
    const endedMs = this.#context.clock.nowMs();
    await this.mark(run, `End of block ${index + 1}`, '');
    const take = run.blocks[index]!.takes.at(-1)!;
    const problem = await this.#stopRecording(take);
    this.abandon(run);
    return endBlock(run, index, { endedMs, problem });
  }

  /** Adds a marker to the recording of the block that runs; a recording that is full or gone has none. */
  async mark(run: StudyRun, text: string, author: string): Promise<void> {
    const index = runningBlock(run);
    if (index === undefined) return;
    const { recordingId } = run.blocks[index]!.takes.at(-1)!;
    const marker: RecordingMarker = { ...EMPTY_MARKER, recordingId, text };
    const { limits, recordings } = this.#context;
    const maxCharacters = limits.limits.reasonCharacters;
    const cut = { ...marker, text: text.replace(/\s+/g, ' ').slice(0, maxCharacters) };
    await recordings.mark(cut, author, true).catch(() => undefined);
  }

  /** Ends what runs with a block besides its recording. */
  abandon(run: StudyRun): void {
    this.#ends.get(run.id)?.();
    this.#ends.delete(run.id);
    const sessionId = this.#sessions.get(run.id);
    this.#sessions.delete(run.id);
    if (sessionId === undefined) return;
    const other = this.#otherRunWith(sessionId, run.id);
    if (other !== undefined) this.#sessions.set(other.id, sessionId);
    else this.#stopSession(sessionId);
  }

  close(): void {
    for (const cancel of this.#ends.values()) cancel();
    this.#ends.clear();
  }

  /** What is wrong with required devices. @throws ServiceError when something is, and the block is not forced [ST-31] */
  async #checkDevices(study: Study, isForced: boolean): Promise<string> {
    const { rows } = await this.#context.checks.checkNow(study);
    const troubles = troublesOf(rows);
    if (troubles === '' || isForced) return troubles;
    throw new ServiceError(
      'failed_precondition',
      `Required devices are not ready: ${troubles}. Set is_forced to begin anyway.`,
    );
  }

  async #record(
    study: Study,
    run: StudyRun,
    index: number,
    forced: string,
    by: StudyLeader,
  ): Promise<{ recording: Recording; runNumber: number }> {
    const { clock, recordings, ownValues, store } = this.#context;
    const { participantCode, visit } = run;
    const { condition, repetition } = run.blocks[index]!;
    const block = index + 1;
    const { name, run: runNumber } = new NameTemplate(study.nameTemplate).firstFree(
      {
        study: study.name,
        participant: participantCode,
        session: visit,
        condition,
        repetition,
        block,
        timeMs: clock.nowMs(),
      },
      this.#takenNames(study.id),
    );
    const part = {
      studyId: study.id,
      studyName: study.name,
      runId: run.id,
      participantCode,
      visit,
      condition,
      block,
      runNumber,
    };
    const notes = forced === '' ? '' : `Begun although required devices were not ready: ${forced}.`;
    // A study and its recordings are of one maker, whoever leads the block. [ST-5]
    const makerId = store.makerOf(study.id);
    const wish = { author: by.author, makerId, name, notes, study: part };
    const selection = study.selection ?? EVERYTHING;
    const mayBeginWith = ownValues.testFor(study, run);
    return { recording: await recordings.start(wish, { selection, mayBeginWith }), runNumber };
  }

  #takenNames(studyId: string): Set<string> {
    const runs = this.#context.store.runs(studyId);
    return new Set(
      runs.flatMap(({ blocks }) => blocks.flatMap(({ takes }) => takes.map(({ name }) => name))),
    );
  }

  /** @returns what is wrong with the recording */
  async #stopRecording({ recordingId }: StudyTake): Promise<string> {
    try {
      return (await this.#context.recordings.stop(recordingId)).problem;
    } catch (cause) {
      return ServiceError.from(cause).message;
    }
  }

  async #startSession(runId: string, id: string, grantId: GrantId | undefined): Promise<void> {
    if (id === '') return;
    const { sessions } = this.#context;
    if ((await sessions.find(id)).isLive) return;
    await sessions.start({ ...EMPTY_SESSION, id }, grantId);
    this.#sessions.set(runId, id);
  }

  #stopSession(id: string): void {
    const { sessions } = this.#context;
    const session = sessions.list().find((each) => each.id === id);
    if (session?.isLive === true) sessions.stop(session);
  }

  /** Another run with a running block of this session. */
  #otherRunWith(sessionId: string, runId: string): StudyRun | undefined {
    return this.#context.store
      .runs()
      .find(
        ({ id, blocks }) =>
          id !== runId &&
          blocks.some(
            (block) =>
              block.sessionId === sessionId &&
              block.state === StudyBlockState.STUDY_BLOCK_STATE_RUNNING,
          ),
      );
  }

  #endAfter(runId: string, recordingId: string, blockMs: number): void {
    if (blockMs === 0) return;
    const { clock, onTimeUp } = this.#context;
    this.#ends.set(
      runId,
      clock.after(blockMs, () => onTimeUp(runId, recordingId)),
    );
  }

  /** [ST-2] */
  #requireRoom({ blocks }: StudyRun): void {
    const { limits } = this.#context;
    const max = limits.limits.studyTakes;
    if (blocks.reduce((sum, { takes }) => sum + takes.length, 0) < max) return;
    throw limits.refusal('studyTakes', `more than ${max} recordings of a run`);
  }
}

/** [ST-22] */
function requireConsent({ consentText }: Study, { consent }: StudyRun): void {
  if (consentText === '' || consent !== undefined) return;
  throw new ServiceError(
    'failed_precondition',
    'The participant has not consented yet. Confirm the consent first.',
  );
}
