import type { DataFormat, ProcessingModule } from '@ubii/proto';
import { parseDataFormat } from '@ubii/proto';

/** Formats of available topics: modules that read them come before others of equal relevance. */
export type FormatsAtHand = ReadonlySet<DataFormat>;

/** Relevance of a module for typed words; 0: no match. Each word must occur. */
export function moduleScore(module: ProcessingModule, words: readonly string[]): number {
  const name = module.name.toLowerCase();
  const parts = name.split(/[-_\s]+/);
  const tags = module.tags.map((tag) => tag.toLowerCase());
  const formats = [...module.inputs, ...module.outputs].map(({ messageFormat }) => messageFormat);
  const text = [module.description, ...formats].join(' ').toLowerCase();
  let score = 1;
  for (const word of words) {
    if (name === word) score += 16;
    else if (parts.some((part) => part.startsWith(word))) score += 8;
    else if (name.includes(word)) score += 6;
    else if (tags.some((tag) => tag.startsWith(word))) score += 4;
    else if (text.includes(word) || tags.some((tag) => tag.includes(word))) score += 2;
    else return 0;
  }
  return score;
}

/**
 * Returns the modules that match the words, by relevance; equally relevant ones by whether they read an available
 * format, then by the number of inputs, fewest first.
 * @param atHand undefined: equally relevant modules keep their order
 */
export function rankModules<T>(
  all: readonly T[],
  moduleOf: (one: T) => ProcessingModule,
  words: readonly string[],
  atHand: FormatsAtHand | undefined,
): T[] {
  const takes = ({ inputs }: ProcessingModule): number =>
    inputs.some(({ messageFormat }) => {
      const format = parseDataFormat(messageFormat);
      return format !== undefined && atHand?.has(format) === true;
    })
      ? 1
      : 0;
  return all
    .map((one) => ({ one, module: moduleOf(one), score: moduleScore(moduleOf(one), words) }))
    .filter(({ score }) => score > 0)
    .sort(
      (a, b) =>
        takes(b.module) - takes(a.module) ||
        b.score - a.score ||
        (atHand !== undefined && words.length > 0
          ? a.module.inputs.length - b.module.inputs.length
          : 0),
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
