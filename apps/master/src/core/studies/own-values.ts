import { compileGlob } from '@ubii/patterns';
import { StudyRunState, type Study, type StudyRun } from '@ubii/proto';
import type { TopicEntry } from '../topics/topic-entry.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import type { StudyStore } from './study-store.ts';

/** What is needed to tell whose values topics have. */
export interface OwnValuesContext {
  readonly store: StudyStore;
  readonly topics: TopicTable;
}

/** Tells which values of topics may begin the recording of a participant. [ST-26] */
export class OwnValues {
  readonly #context: OwnValuesContext;
  /** The only participant with open runs, and the newest record before that was so; undefined when there are none or several. */
  #only: { readonly participant: string; readonly sequence: number } | undefined = undefined;

  constructor(context: OwnValuesContext) {
    this.#context = context;
    context.store.onRunsChanged.add(() => this.#update());
  }

  /** Returns a test: whether a recording of the run may begin with the value of a topic. */
  testFor({ settingPatterns }: Study, run: StudyRun): (entry: TopicEntry) => boolean {
    const isSetting = settingPatterns.map(compileGlob);
    const only = this.#only?.participant === participantOf(run) ? this.#only : undefined;
    return ({ topic, sequence }) =>
      (only !== undefined && sequence > only.sequence) || isSetting.some((test) => test(topic));
  }

  #update(): void {
    const { store, topics } = this.#context;
    const open = store.runs().filter(({ state }) => state === StudyRunState.STUDY_RUN_STATE_OPEN);
    const [participant, ...others] = new Set(open.map(participantOf));
    if (participant === undefined || others.length > 0) this.#only = undefined;
    else if (this.#only?.participant !== participant) {
      this.#only = { participant, sequence: topics.sequence };
    }
  }
}

/** The same code in two studies may be two people. */
const participantOf = ({ studyId, participantCode }: StudyRun): string =>
  `${studyId} ${participantCode.toLowerCase()}`;
