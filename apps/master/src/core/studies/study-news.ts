import {
  STUDY_STATUS_TOPIC,
  StudyRunState,
  type Study,
  type StudyRun,
  type StudyRunNews,
} from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import type { MasterPublisher } from '../info/master-publisher.ts';
import { runningBlock } from './run-changes.ts';
import type { StudyChecks } from './study-checks.ts';
import type { StudyStore } from './study-store.ts';

/** Time between news while a run is open or a check list is wanted, milliseconds. [ST-40] */
const INTERVAL_MS = 1_000;

/** What news of studies work with. */
export interface StudyNewsContext {
  readonly clock: Clock;
  readonly publisher: MasterPublisher;
  readonly store: StudyStore;
  readonly checks: StudyChecks;
}

/** Publishes open runs and check lists. [ST-40] */
export class StudyNews {
  readonly #context: StudyNewsContext;
  #cancel: Cancel | undefined = undefined;

  constructor(context: StudyNewsContext) {
    this.#context = context;
  }

  /** Something has changed, or a check list is wanted. */
  announce(): void {
    this.#publish();
    if (!this.#isNeeded()) return;
    this.#context.checks.measure();
    this.#cancel ??= this.#context.clock.every(INTERVAL_MS, () => this.#tick());
  }

  close(): void {
    this.#cancel?.();
    this.#cancel = undefined;
  }

  #tick(): void {
    this.#context.checks.measure();
    this.#publish();
    if (!this.#isNeeded()) this.close();
  }

  #isNeeded(): boolean {
    return this.#openRuns().length > 0 || this.#context.checks.wanted().length > 0;
  }

  #openRuns(): StudyRun[] {
    return this.#context.store
      .runs()
      .filter(({ state }) => state === StudyRunState.STUDY_RUN_STATE_OPEN);
  }

  #publish(): void {
    const { publisher, store, checks, clock } = this.#context;
    const open = this.#openRuns();
    const ids = new Set([...open.map(({ studyId }) => studyId), ...checks.wanted()]);
    const studies = [...ids].map((id) => store.find(id)).filter((study) => study !== undefined);
    const nowMs = clock.nowMs();
    publisher.publish(STUDY_STATUS_TOPIC, {
      studyStatus: {
        runs: open.map((run) => newsOf(run, store.find(run.studyId), nowMs)),
        checkLists: studies.map((study) => checks.check(study)),
        listRevision: store.revision,
      },
    });
  }
}

function newsOf(run: StudyRun, study: Study | undefined, nowMs: number): StudyRunNews {
  const index = runningBlock(run);
  const take = index === undefined ? undefined : run.blocks[index]?.takes.at(-1);
  return {
    runId: run.id,
    studyId: run.studyId,
    revision: run.revision,
    block: index === undefined ? 0 : index + 1,
    recordingId: take?.recordingId ?? '',
    elapsedMs: take === undefined ? 0 : nowMs - take.startedMs,
    blockMs: take === undefined ? 0 : (study?.blockMs ?? 0),
  };
}
