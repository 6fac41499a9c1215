import { counted } from '@ubii/words';

import type { EventKind } from '../records/recording-event.ts';
import type { RecordingSummary } from '../records/recording-summary.ts';
import type { LabelledTexts } from './known-people.ts';

/** Where a labelled text stood elsewhere: a topic, or what its words say. */
export type Place = { readonly topic: string } | EventKind | 'topic name' | 'header';

const WORDS = {
  'topic name': 'names of topics',
  header: 'texts on the recording',
  client: 'clients',
  device: 'devices',
  session: 'sessions',
  clock: 'clocks',
  marker: 'markers',
  gap: 'gaps',
} as const;

/** What a treatment found of labelled texts, for the one who shares the recording. [PD-18] */
export class TreatmentReport {
  readonly #labelled: Pick<LabelledTexts, 'short' | 'isIncomplete'>;
  readonly #found = new Set<string>();
  readonly #topics = new Set<string>();
  readonly #places = new Set<keyof typeof WORDS>();
  readonly #code = new Set<string>();

  constructor(labelled: Pick<LabelledTexts, 'short' | 'isIncomplete'>) {
    this.#labelled = labelled;
  }

  /** Notes that a labelled text stood somewhere. Once or often is the same: exports read records twice. */
  note(text: string, place: Place): void {
    this.#found.add(text);
    if (typeof place === 'string') this.#places.add(place);
    else this.#topics.add(place.topic);
  }

  /** Notes that code was left out. */
  noteCode(code: string): void {
    this.#code.add(code);
  }

  /** Sentences without their ends. */
  sentences(): readonly string[] {
    const { short, isIncomplete } = this.#labelled;
    const [found, code] = [this.#found.size, this.#code.size];
    const topics = this.#topics.size === 0 ? [] : [counted(this.#topics.size, 'topic')];
    const places = [...topics, ...[...this.#places].map((place) => WORDS[place]).toSorted()];
    return [
      found === 0
        ? ''
        : `Replaced elsewhere: ${counted(found, 'labelled value')}, in ${places.join(', ')}`,
      code === 0
        ? ''
        : `Left out: the code of ${counted(code, 'function')} of modules, because a labelled value stands in it`,
      short === 0
        ? ''
        : `Not searched for elsewhere: ${counted(short, 'labelled value')} of fewer than 3 characters, or of numbers with fewer than 5 digits`,
      isIncomplete
        ? 'Not searched for elsewhere: labelled values beyond the first 50000, or beyond 4 million characters'
        : '',
    ].filter(Boolean);
  }
}

/** Says which parts of other programs a shared copy leaves out, such as `2 attachments of other programs`; empty for none. [PD-14] */
export function leftOutParts({ foreignParts }: Pick<RecordingSummary, 'foreignParts'>): string {
  const { attachments, metadata } = foreignParts;
  const parts = [
    attachments.length > 0 ? counted(attachments.length, 'attachment') : '',
    metadata.length > 0 ? counted(metadata.length, 'metadata record') : '',
  ].filter(Boolean);
  return parts.length === 0 ? '' : `${parts.join(' and ')} of other programs`;
}
