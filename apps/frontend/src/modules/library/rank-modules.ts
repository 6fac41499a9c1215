import type { DataFormat, ProcessingModule } from '@ubii/proto';
import { parseDataFormat } from '@ubii/proto';

/** What is at hand: modules that take it come before others that are as good. */
export type FormatsAtHand = ReadonlySet<DataFormat>;

/** How well a module answers words that were typed; 0: not at all. Each word has to be somewhere. */
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
 * Modules that answer the words, the best first; of those that are equally good, the ones that take
 * what is at hand, then those with the fewest inputs: they are the quickest to use.
 * @param atHand undefined: those that are equally good keep their order
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

/** `vector2 → vector2`: what goes in and comes out first. */
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

/** The first sentence of what a module says of itself. */
export function firstSentence(text: string): string {
  return /^.*?[.!?](?=\s|$)/s.exec(text.trim())?.[0] ?? text.trim();
}
