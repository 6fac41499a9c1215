import { valueOf } from '../../formats/value-parts.ts';
import type { Port } from '../model/graph.ts';
import { defaultText } from '../../formats/default-text.ts';

/** Option of an input with a list of accepted texts. [PM-7] */
export interface ChoiceOption {
  readonly value: string;
  readonly text: string;
  /** True when the input does not accept it: it is kept and marked. */
  readonly isUnknown: boolean;
}

/** Whether a constant is not among the texts that its input accepts. */
export function isUnknownChoice(
  { choices = [], defaultJson }: Pick<Port, 'choices' | 'defaultJson'>,
  json: string,
): boolean {
  const [first] = choiceOptions(choices, textOf(json), defaultJson);
  return choices.length > 0 && first?.isUnknown === true;
}

/** Returns the text of a constant such as `{"string":"auto"}`; for other constants, the JSON. */
export function textOf(json: string): string {
  const value = valueOf('string', json);
  return typeof value === 'string' ? value : json;
}

/** Label for an empty text. */
const EMPTY = 'empty';

/**
 * Returns the options: the current text if it is not accepted, the accepted texts, and the default if it is not among
 * them.
 *
 * @param current current text; undefined: not set
 * @param fallback the default as JSON such as `{"string":"auto"}`; undefined: none
 */
export function choiceOptions(
  choices: readonly string[],
  current: string | undefined,
  fallback: string | undefined,
): readonly ChoiceOption[] {
  const standard = defaultText(fallback);
  const known = new Set(standard === undefined ? choices : [...choices, standard]);
  const isUnknown = current !== undefined && !known.has(current);
  return [
    ...(isUnknown
      ? [{ value: current, text: `${current || EMPTY} (unknown)`, isUnknown: true }]
      : []),
    ...[...known].map((value) => ({ value, text: value || EMPTY, isUnknown: false })),
  ];
}
