import type { DataFormat, ProcessingModule } from '@ubii/proto';
import { parseDataFormat } from '@ubii/proto';
import { searchScore, type Searched } from '../../ui/find-words.ts';

/** Formats of available topics: modules that read them come before others of equal relevance. */
export type FormatsAtHand = ReadonlySet<DataFormat>;

/** What a search has to know of an entry. */
export interface Findable extends Searched {
  readonly module?: ProcessingModule | undefined;
}

/** What can be searched of a module. */
export function findableModule(module: ProcessingModule): Findable {
  const { name, tags, description, inputs, outputs } = module;
  const formats = [...inputs, ...outputs].map(({ messageFormat }) => messageFormat);
  return { name, aliases: tags, text: [description, ...formats].join(' '), module };
}

/** Order of entries that are equally relevant. */
export interface RankOptions {
  /** Undefined: modules that read an available format keep their places. */
  readonly atHand?: FormatsAtHand | undefined;
  /** Names of modules that the user marked, which come first. */
  readonly favourites?: readonly string[] | undefined;
  /** Names of modules that were used lately, which come next. */
  readonly recent?: readonly string[] | undefined;
}

/**
 * Returns the entries that match all words: name, word in the name, tag, sentence. Equally relevant ones: favourites, then
 * by recent use, by whether they read an available format, then by the number of inputs, fewest first.
 * @param words in lower case
 */
export function rankFound<T>(
  all: readonly T[],
  findable: (one: T) => Findable,
  words: readonly string[],
  { atHand, favourites = [], recent = [] }: RankOptions,
): T[] {
  const isIn = (names: readonly string[], module: ProcessingModule | undefined): number =>
    module !== undefined && names.includes(module.name) ? 1 : 0;
  const takes = (module: ProcessingModule | undefined): number =>
    module?.inputs.some(({ messageFormat }) => {
      const format = parseDataFormat(messageFormat);
      return format !== undefined && atHand?.has(format) === true;
    }) === true
      ? 1
      : 0;
  const isCounted = atHand !== undefined && words.length > 0;
  return all
    .map((one) => {
      const found = findable(one);
      const { module } = found;
      const inputs = isCounted ? (module?.inputs.length ?? 0) : 0;
      const score = searchScore(found, words);
      const [marked, used] = [isIn(favourites, module), isIn(recent, module)];
      return { one, score, inputs, marked, used, takes: takes(module) };
    })
    .filter(({ score }) => score > 0)
    .sort(
      (a, b) =>
        b.score - a.score ||
        b.marked - a.marked ||
        b.used - a.used ||
        b.takes - a.takes ||
        a.inputs - b.inputs,
    )
    .map(({ one }) => one);
}

/** `vector2 → vector2`: formats of the first input and output. */
export function moduleFlow(
  { inputs, outputs }: Pick<ProcessingModule, 'inputs' | 'outputs'>,
  formatText: (format: string) => string,
): string {
  const end = (ios: ProcessingModule['inputs']): string => {
    const [first, ...more] = ios;
    if (first === undefined) return 'nothing';
    const text = formatText(first.messageFormat) || 'any';
    return `${text}${first.isRecordList ? ' list' : ''}${more.length > 0 ? ` +${more.length}` : ''}`;
  };
  return `${end(inputs)} → ${end(outputs)}`;
}

/** First sentence of a module's description. */
export function firstSentence(text: string): string {
  return /^.*?[.!?](?=\s|$)/s.exec(text.trim())?.[0] ?? text.trim();
}
