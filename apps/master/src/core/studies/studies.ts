import { ServiceError, type Study, type StudyCheckList, type StudyList } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { IdSource } from '../ports/id-source.ts';
import { quote } from '../texts/quote.ts';
import { completeStudy } from './complete-study.ts';
import type { StudyChecks } from './study-checks.ts';
import type { StudyNews } from './study-news.ts';
import type { StudyStore } from './study-store.ts';
import type { Turns } from './turns.ts';

/** What studies work with. */
export interface StudiesContext {
  readonly clock: Clock;
  readonly ids: IdSource;
  readonly limits: LimitWatch;
  readonly store: StudyStore;
  readonly checks: StudyChecks;
  readonly news: StudyNews;
  readonly turns: Turns;
}

/** Studies of the master. [ST-1] to [ST-4] */
export class Studies {
  readonly #context: StudiesContext;

  constructor(context: StudiesContext) {
    this.#context = context;
  }

  /** @param isWanted whether studies of this maker are listed [ST-5] */
  list(isWanted: (makerId: string) => boolean): StudyList {
    const { store } = this.#context;
    const studies = store.studies().filter(({ id }) => isWanted(store.makerOf(id)));
    const elements = studies.map((study) => ({
      ...this.#counted(study),
      ...{ notes: '', consentText: '', earlierConsentTexts: [] },
    }));
    return { elements };
  }

  get(id: string): Study {
    return this.#counted(this.#context.store.require(id));
  }

  /** Whose a study is. [ST-5] @throws ServiceError when there is none of this id */
  makerOf(id: string): string {
    const { store } = this.#context;
    return store.makerOf(store.require(id).id);
  }

  /** Name of a study, for the audit log; its id when there is none. */
  nameOf(id: string): string {
    return this.#context.store.find(id)?.name ?? id;
  }

  /** [ST-3] @param makerId of a new study */
  save(wanted: Study, makerId: string): Promise<Study> {
    const { store, turns, news, limits, ids, clock } = this.#context;
    const study = completeStudy(wanted, limits);
    return turns.run(async () => {
      const known = wanted.id === '' ? undefined : store.require(wanted.id);
      requireRevision(wanted, known);
      const id = known?.id ?? ids.uuid();
      const kept = { ...study, id, revision: wanted.revision + 1, changedMs: clock.nowMs() };
      await store.save({ ...kept, ...this.#consentOf(study, known) }, makerId);
      news.tell();
      return this.get(id);
    });
  }

  /** [ST-4] */
  delete(id: string): Promise<void> {
    const { store, turns, news, checks } = this.#context;
    return turns.run(async () => {
      const study = this.#counted(store.require(id));
      if (study.participantCount > 0) {
        throw new ServiceError(
          'failed_precondition',
          `The study ${quote(study.name)} has participants. Delete them first.`,
        );
      }
      await store.delete(id);
      checks.forget(id);
      news.tell();
    });
  }

  /** Checks required devices now, and for some time from now on. [ST-32] */
  async check(id: string): Promise<StudyCheckList> {
    const { store, checks, news } = this.#context;
    const study = store.require(id);
    checks.want(id);
    news.tell();
    return checks.checkNow(study);
  }

  #counted(study: Study): Study {
    const runs = this.#context.store.runs(study.id);
    const codes = new Set(runs.map(({ participantCode }) => participantCode));
    return { ...study, participantCount: codes.size, runCount: runs.length };
  }

  /** The version of the consent text, and the earlier ones that participants consented to. [ST-22] */
  #consentOf(
    { consentText }: Study,
    known: Study | undefined,
  ): Pick<Study, 'consentVersion' | 'earlierConsentTexts'> {
    const { store, limits } = this.#context;
    const version = known?.consentVersion ?? 0;
    const texts = known?.earlierConsentTexts ?? [];
    if (known?.consentText === consentText || (known === undefined && consentText === '')) {
      return { consentVersion: version, earlierConsentTexts: texts };
    }
    const consented = new Set(store.runs(known?.id).map(({ consent }) => consent?.version));
    const all = known === undefined ? [] : [...texts, { version, text: known.consentText }];
    const earlierConsentTexts = all.filter((each) => consented.has(each.version));
    const max = limits.limits.studyConsentTexts;
    if (earlierConsentTexts.length > max) {
      const text = `more than ${max} earlier consent texts of a study`;
      throw limits.refusal('studyConsentTexts', text);
    }
    return { consentVersion: version + 1, earlierConsentTexts };
  }
}

/** @throws ServiceError when another revision was changed [ST-3] */
function requireRevision({ revision }: Study, known: Study | undefined): void {
  const expected = known?.revision ?? 0;
  if (revision === expected) return;
  throw new ServiceError(
    'failed_precondition',
    known === undefined
      ? `The member revision is ${revision}, but a new study has 0.`
      : `The study ${quote(known.name)} is at revision ${expected}, but revision ${revision} was changed: another client has changed it since. Get it, and make the change again.`,
  );
}
