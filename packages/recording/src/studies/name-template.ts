import { capitalised } from '@ubii/words';
import { ServiceError } from '@ubii/proto';

/**
 * The label of a name: its letters and digits (ASCII), each word after the first with a capital. [ST-13]
 * @returns an empty text when there are none
 */
export function labelOf(name: string): string {
  return name
    .split(/[^A-Za-z0-9]+/)
    .filter(Boolean)
    .map((word, index) => (index === 0 ? word : capitalised(word)))
    .join('');
}

/** A number as a label: two digits at least. [ST-13] */
export function labelOfNumber(number: number): string {
  return String(number).padStart(2, '0');
}

/** What the name of a recording is made of. */
export interface NameFacts {
  readonly study: string;
  readonly participant: string;
  /** The visit. */
  readonly session: string;
  readonly condition: string;
  readonly repetition: number;
  readonly block: number;
  /** Epoch milliseconds. */
  readonly timeMs: number;
}

type Values = NameFacts & { readonly run: number };

/** As in the Brain Imaging Data Structure, https://bids-specification.readthedocs.io, "Filenames". */
export const DEFAULT_NAME_TEMPLATE = 'sub-{participant}_ses-{session}_task-{condition}_run-{run}';

const PLACEHOLDERS: ReadonlyMap<string, (values: Values) => string> = new Map([
  ['study', ({ study }) => labelOf(study)],
  ['participant', ({ participant }) => participant],
  ['session', ({ session }) => session],
  ['condition', ({ condition }) => labelOf(condition)],
  ['repetition', ({ repetition }) => labelOfNumber(repetition)],
  ['block', ({ block }) => labelOfNumber(block)],
  ['run', ({ run }) => labelOfNumber(run)],
  ['date', ({ timeMs }) => new Date(timeMs).toISOString().slice(0, 10).replaceAll('-', '')],
]);
/** Names that may stand in braces. */
export const NAME_PLACEHOLDERS: readonly string[] = [...PLACEHOLDERS.keys()];
const REQUIRED = ['participant', 'run'];
const TEXT = /^[A-Za-z0-9._-]*$/;
/** Texts, and at the odd places what stands in braces. */
const PARTS = /\{([^{}]*)\}/;

/** Template of names of recordings. [ST-12] */
export class NameTemplate {
  readonly #parts: readonly string[];

  /** @param text empty for the default @throws ServiceError when it is none */
  constructor(text: string) {
    this.#parts = (text === '' ? DEFAULT_NAME_TEMPLATE : text).split(PARTS);
    this.#check();
  }

  /** Whether the placeholder of this name is in it. */
  uses(name: string): boolean {
    return this.#parts.some((part, index) => index % 2 === 1 && part === name);
  }

  format(values: Values): string {
    return this.#parts
      .map((part, index) => (index % 2 === 0 ? part : PLACEHOLDERS.get(part)!(values)))
      .join('');
  }

  /** The first name that is not taken, with its `{run}`. [ST-14] */
  firstFree(facts: NameFacts, taken: ReadonlySet<string>): { name: string; run: number } {
    for (let run = 1; ; run++) {
      const name = this.format({ ...facts, run });
      if (!taken.has(name)) return { name, run };
    }
  }

  #check(): void {
    const texts = this.#parts.filter((_, index) => index % 2 === 0);
    const names = this.#parts.filter((_, index) => index % 2 === 1);
    const unknown = names.find((name) => !PLACEHOLDERS.has(name));
    if (unknown !== undefined) {
      throw invalid(`has the unknown placeholder "{${unknown}}"`);
    }
    const missing = REQUIRED.find((name) => !names.includes(name));
    if (missing !== undefined) throw invalid(`does not have {${missing}}`);
    const text = texts.find((each) => !TEXT.test(each));
    if (text !== undefined) throw invalid(`has the text ${JSON.stringify(text)}`);
    if (texts[0]!.startsWith('.') || texts.at(-1)!.endsWith('.')) {
      throw invalid('has a dot at its beginning or end');
    }
  }
}

function invalid(what: string): ServiceError {
  const known = NAME_PLACEHOLDERS.map((name) => `{${name}}`).join(', ');
  return new ServiceError(
    'invalid_argument',
    `The name template ${what}. Use ${known}, at least {participant} and {run}, and between them letters, digits, "-", "_" and ".".`,
  );
}
