import { fromJson, ServiceError, toJson, type PersonalData, type PersonalLabel } from '@ubii/proto';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { DocumentStore } from '../ports/document-store.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { Log } from '../ports/log.ts';
import { checkLabel } from './check-label.ts';

const KEY = 'labels';
const TYPE = 'ubii.extension.PersonalData';

/** What labels work with. */
export interface PersonalLabelsContext {
  readonly ids: IdSource;
  readonly limits: LimitWatch;
  readonly log: Log;
  readonly store: DocumentStore;
}

/** Which values in topics are personal. [PD-3] */
export class PersonalLabels {
  readonly #context: PersonalLabelsContext;
  #labels: readonly PersonalLabel[];

  constructor(context: PersonalLabelsContext) {
    this.#context = context;
    this.#labels = this.#read();
  }

  get(): PersonalData {
    return { labels: [...this.#labels] };
  }

  /** As JSON for the header of a recording; empty without labels. [PD-6] */
  toHeader(): string {
    return this.#labels.length === 0 ? '' : JSON.stringify(toJson(TYPE, this.get()));
  }

  /** Replaces all labels. They count when the promise is fulfilled. [PD-4] @throws ServiceError for an impossible label, or too many */
  async set({ labels }: PersonalData): Promise<PersonalData> {
    const { ids, limits, store } = this.#context;
    const max = limits.limits.personalLabels;
    if (labels.length > max) {
      throw limits.refusal('personalLabels', `more than ${max} labels of personal data`);
    }
    const used = new Set<string>();
    const checked = labels.map((label) => {
      const id = label.id === '' ? ids.uuid() : label.id;
      const problem = used.has(id) ? `its id is that of another label` : checkLabel(label);
      if (problem !== undefined) {
        throw new ServiceError(
          'invalid_argument',
          `The label ${used.size + 1} is refused: ${problem}.`,
        );
      }
      used.add(id);
      return { ...label, id };
    });
    await store.write(KEY, toJson(TYPE, { labels: checked }));
    this.#labels = checked;
    return this.get();
  }

  #read(): readonly PersonalLabel[] {
    const { store, log } = this.#context;
    const document = store.documents().get(KEY);
    if (document === undefined) return [];
    try {
      if (document.fault !== undefined) throw new Error(document.fault);
      return fromJson(TYPE, document.json).labels;
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      log.error('the labels of personal data cannot be read', {
        where: store.describe(KEY),
        reason,
      });
      return [];
    }
  }
}
