import {
  PersonalTreatment,
  type PersonalLabel,
  fromJson,
  ServiceError,
  toJson,
  type PersonalData,
} from '@ubii/proto';
import { isTreatable, parseFieldPath } from '@ubii/recording/personal';
import { quote } from '../texts/quote.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { DocumentStore } from '../ports/document-store.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { Log } from '../ports/log.ts';

const WORDS = new Map<PersonalTreatment, string>([
  [PersonalTreatment.PERSONAL_TREATMENT_DROP, 'dropped'],
  [PersonalTreatment.PERSONAL_TREATMENT_PSEUDONYM, 'replaced by pseudonyms'],
  [PersonalTreatment.PERSONAL_TREATMENT_ROUND, 'rounded'],
]);

/** What is wrong with a label, to be read after "The label is refused:"; undefined when nothing is. [PD-2] */
function checkLabel({
  topicPattern,
  fieldPath,
  treatment,
  step,
}: PersonalLabel): string | undefined {
  if (!/^[/*]/.test(topicPattern)) {
    return `the pattern ${quote(topicPattern)} names no topics. Patterns begin with "/" or "*"`;
  }
  const path = parseFieldPath(fieldPath);
  if (path === undefined) {
    return `no data format has the member ${quote(fieldPath)}. Use a path such as "object2DList.elements.id"`;
  }
  const word = WORDS.get(treatment);
  if (word === undefined) return `the treatment ${treatment} is unknown`;
  const member = path.at(-1);
  if (member !== undefined && !isTreatable(member, treatment)) {
    return `values of ${quote(fieldPath)} cannot be ${word}`;
  }
  return step >= 0 && Number.isFinite(step) ? undefined : `the step ${step} is no number from 0 on`;
}

const KEY = 'labels';
const TYPE = 'ubii.extension.PersonalData';

/** What labels work with. */
interface PersonalLabelsContext {
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
