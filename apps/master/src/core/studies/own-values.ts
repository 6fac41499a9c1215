import { compileGlob } from '@ubii/patterns';
import { StudyRunState, type Study, type StudyRun } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { MayBeginWith } from '../recordings/record-collector.ts';
import type { TopicEntry } from '../topics/topic-entry.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import type { StudyStore } from './study-store.ts';

/** What is needed to tell whose values topics have. */
export interface OwnValuesContext {
  readonly store: StudyStore;
  readonly topics: TopicTable;
  readonly clock: Clock;
}

/** Tells which values of topics may begin the recording of a participant. [ST-26] */
export class OwnValues {
  readonly #context: OwnValuesContext;
  /** The only participant with open runs, and the newest record before that was so; undefined when there are none or several. */
  #only:
    | { readonly participant: string; readonly sequence: number; readonly sinceMs: number }
    | undefined = undefined;

  constructor(context: OwnValuesContext) {
    this.#context = context;
    context.store.onRunsChanged.add(() => this.#update());
  }

  /** Returns a test: whether a recording of the run may begin with the value of a topic. */
  testFor({ settingPatterns }: Study, run: StudyRun): MayBeginWith {
    const isSetting = settingPatterns.map(compileGlob);
    const only = this.#only?.participant === participantOf(run) ? this.#only : undefined;
    const isOwn = ({ sequence, originId, stamp }: TopicEntry): boolean => {
      if (only === undefined || sequence <= only.sequence) return false;
      return originId === undefined || stamp >= only.sinceMs; // A value of another master may have come late.
    };
    return (entry) => isOwn(entry) || isSetting.some((test) => test(entry.topic));
  }

  #update(): void {
    const { store, topics, clock } = this.#context;
    const open = store.runs().filter(({ state }) => state === StudyRunState.STUDY_RUN_STATE_OPEN);
    const [participant, ...others] = new Set(open.map(participantOf));
    if (participant === undefined || others.length > 0) this.#only = undefined;
    else if (this.#only?.participant !== participant) {
      this.#only = { participant, sequence: topics.sequence, sinceMs: clock.nowMs() };
    }
  }
}

/** The same code in two studies may be two people. */
const participantOf = ({ studyId, participantCode }: StudyRun): string =>
  `${studyId} ${participantCode.toLowerCase()}`;
