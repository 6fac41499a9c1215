import { valueOf } from '../../formats/value-parts.ts';
import type { Port } from '../model/graph.ts';
import { defaultText } from './default-text.ts';

/** One entry of the list of an input that understands certain texts. [PM-7] */
export interface ChoiceOption {
  readonly value: string;
  readonly text: string;
  /** The input does not understand it: it is kept and marked. */
  readonly isUnknown: boolean;
}

/** Whether a constant is none of the texts that its input understands. */
export function isUnknownChoice(
  { choices = [], defaultJson }: Pick<Port, 'choices' | 'defaultJson'>,
  json: string,
): boolean {
  const [first] = choiceOptions(choices, textOf(json), defaultJson);
  return choices.length > 0 && first?.isUnknown === true;
}

/** The text of a constant such as `{"string":"auto"}`; of another one, how it is written. */
export function textOf(json: string): string {
  const value = valueOf('string', json);
  return typeof value === 'string' ? value : json;
}

/** What stands for a text without letters. */
const EMPTY = 'empty';

/**
 * The texts to choose from: an unknown one that is set, the choices, and the default where it is none of them.
 *
 * @param current the text that is set; undefined: none
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
