import { findJsonProblems, fromJson, type PersonalLabel } from '@ubii/proto';

import { RecordingError } from '../records/recording-error.ts';
import type { RecordingHeader } from '../records/recording-header.ts';

/** What is replaced or dropped when a recording is shared. */
export interface PersonalRules {
  /** Values in topics; later ones apply to what earlier ones left. */
  readonly labels: readonly PersonalLabel[];
  /** Ids and names of clients, and names of devices and authors, wherever they are found. */
  readonly clients: 'pseudonym' | 'keep';
  /** Name and notes of the recording. */
  readonly notes: 'drop' | 'keep';
  /** Texts of markers; names of clients in them are replaced. */
  readonly markerTexts: 'drop' | 'keep';
  /** Shift moves all absolute times by the offset of the key. */
  readonly time: 'keep' | 'shift';
}

/** Rules of a recording that is shared, without labels. */
export const SHARING_RULES: PersonalRules = {
  labels: [],
  clients: 'pseudonym',
  notes: 'drop',
  markerTexts: 'keep',
  time: 'keep',
};

const CHOICES = {
  clients: ['pseudonym', 'keep'],
  notes: ['drop', 'keep'],
  markerTexts: ['drop', 'keep'],
  time: ['keep', 'shift'],
} as const;

/**
 * Parses rules: JSON with the members of `PersonalRules`, labels as `ubii.extension.PersonalLabel`. What is missing is as in
 * `SHARING_RULES`.
 *
 * @throws RecordingError when they cannot be read, so that a typing error does not leave personal data in
 */
export function parsePersonalRules(text: string): PersonalRules {
  const { labels, ...choices } = parseObject(text);
  for (const [name, value] of Object.entries(choices)) {
    const allowed: readonly unknown[] | undefined = Object.hasOwn(CHOICES, name)
      ? CHOICES[name as keyof typeof CHOICES]
      : undefined;
    if (allowed?.includes(value) === true) continue;
    const expected = allowed ? allowed.join(' or ') : `one of ${Object.keys(CHOICES).join(', ')}`;
    throw new RecordingError(
      `The rules have "${name}": ${JSON.stringify(value)}, expected ${expected}.`,
    );
  }
  const data = { labels: labels ?? [] };
  // A member that is not known would be passed over, and leave its values in.
  const [problem] = findJsonProblems('ubii.extension.PersonalData', data);
  if (problem) throw new RecordingError(`In the rules, ${problem.path} ${problem.sentence}.`);
  return { ...SHARING_RULES, ...choices, labels: labelsFrom(data) };
}

/** The labels in the header of a recording. @throws RecordingError when they cannot be read */
export function labelsOf({ personalData = '' }: RecordingHeader): readonly PersonalLabel[] {
  return personalData === '' ? [] : labelsFrom(parseObject(personalData));
}

function labelsFrom(data: Readonly<Record<string, unknown>>): readonly PersonalLabel[] {
  try {
    return fromJson('ubii.extension.PersonalData', data).labels;
  } catch (cause) {
    throw new RecordingError('The labels of personal data cannot be read.', { cause });
  }
}

function parseObject(text: string): Readonly<Record<string, unknown>> {
  try {
    const value: unknown = JSON.parse(text);
    if (typeof value === 'object' && value !== null && !Array.isArray(value)) return { ...value };
  } catch {
    // Said below.
  }
  throw new RecordingError('The rules for personal data are no JSON object.');
}
