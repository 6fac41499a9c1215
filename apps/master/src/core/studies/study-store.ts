import {
  fromJson,
  ServiceError,
  toJson,
  type JsonObject,
  type Study,
  type StudyRun,
} from '@ubii/proto';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { Hook } from '../hooks/hook.ts';
import type { DocumentStore, StudyStorage } from '../ports/document-store.ts';
import type { Log } from '../ports/log.ts';
import { quote } from '../texts/quote.ts';
import { interrupted } from './run-changes.ts';

/** What a store of studies works with. */
export interface StudyStoreContext {
  readonly storage: StudyStorage;
  readonly limits: LimitWatch;
  readonly log: Log;
}

/** Studies and their runs, in memory and on disk. [ST-1] */
export class StudyStore {
  readonly #context: StudyStoreContext;
  readonly #studies = new Map<string, Study>();
  readonly #runs = new Map<string, StudyRun>();
  /** Whose studies are; those of earlier versions have no maker. [ST-5] */
  readonly #makers = new Map<string, string>();
  /** Called when a run was saved or deleted. */
  readonly onRunsChanged = new Hook<[]>();
  /** Grows with each change. */
  revision = 1;

  constructor(context: StudyStoreContext) {
    this.#context = context;
    const { studies, runs } = context.storage;
    this.#read(studies, ({ makerId, ...json }, id) => {
      this.#studies.set(id, { ...fromJson('ubii.extension.Study', json), id });
      this.#makers.set(id, typeof makerId === 'string' ? makerId : '');
    });
    this.#read(runs, (json, id) => {
      this.#runs.set(id, interrupted({ ...fromJson('ubii.extension.StudyRun', json), id }));
    });
  }

  /** By name. */
  studies(): Study[] {
    return [...this.#studies.values()].sort((a, b) => a.name.localeCompare(b.name, 'en'));
  }

  find(id: string): Study | undefined {
    return this.#studies.get(id);
  }

  /** Whose a study is; empty when nobody's is known, and without a study. [ST-5] */
  makerOf(id: string): string {
    return this.#makers.get(id) ?? '';
  }

  /** @throws ServiceError when there is none of this id */
  require(id: string): Study {
    const study = this.#studies.get(id);
    if (study !== undefined) return study;
    throw new ServiceError('not_found', `No study has the id ${quote(id)}.`);
  }

  /** The newest first. @param studyId empty for all */
  runs(studyId = ''): StudyRun[] {
    return [...this.#runs.values()]
      .filter((run) => studyId === '' || run.studyId === studyId)
      .sort((a, b) => b.startedMs - a.startedMs || b.participantNumber - a.participantNumber);
  }

  /** @throws ServiceError when there is none of this id */
  requireRun(id: string): StudyRun {
    const run = this.#runs.get(id);
    if (run !== undefined) return run;
    throw new ServiceError('not_found', `No run of a study has the id ${quote(id)}.`);
  }

  /** @param makerId of a new study @throws ServiceError when there is no room for another study [ST-2] */
  async save(study: Study, makerId: string): Promise<void> {
    const { storage, limits } = this.#context;
    const max = limits.limits.studies;
    if (!this.#studies.has(study.id) && this.#studies.size >= max) {
      throw limits.refusal('studies', `more than ${max} studies`);
    }
    const maker = this.#makers.get(study.id) ?? makerId;
    await storage.studies.write(study.id, {
      ...toJson('ubii.extension.Study', study),
      makerId: maker,
    });
    this.#studies.set(study.id, study);
    this.#makers.set(study.id, maker);
    this.revision++;
  }

  async delete(id: string): Promise<void> {
    await this.#context.storage.studies.delete(id);
    this.#studies.delete(id);
    this.#makers.delete(id);
    this.revision++;
  }

  /** @throws ServiceError when there is no room for another run [ST-2] */
  async saveRun(run: StudyRun): Promise<void> {
    const { storage, limits } = this.#context;
    const max = limits.limits.studyRuns;
    if (!this.#runs.has(run.id) && this.runs(run.studyId).length >= max) {
      throw limits.refusal('studyRuns', `more than ${max} runs of a study`);
    }
    await storage.runs.write(run.id, toJson('ubii.extension.StudyRun', run));
    this.#runs.set(run.id, run);
    this.revision++;
    this.onRunsChanged.emit();
  }

  async deleteRun(id: string): Promise<void> {
    await this.#context.storage.runs.delete(id);
    this.#runs.delete(id);
    this.revision++;
    this.onRunsChanged.emit();
  }

  #read(store: DocumentStore, take: (json: JsonObject, id: string) => void): void {
    for (const [id, { json, fault }] of store.documents()) {
      try {
        if (fault !== undefined) throw new Error(fault);
        take({ ...(json as JsonObject) }, id);
      } catch (error) {
        const reason = error instanceof Error ? error.message : String(error);
        this.#context.log.warn('a study cannot be read', { where: store.describe(id), reason });
      }
    }
  }
}
