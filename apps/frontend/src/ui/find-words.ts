import { isWordStart } from './fuzzy.ts';

/** Words of a query, in lower case. */
export const queryWords = (typed: string): string[] =>
  typed.toLowerCase().split(/\s+/).filter(Boolean);

/** Where a word of a query begins in a text. */
export interface WordPlace {
  /** At the beginning of the text. */
  readonly isFirst: boolean;
  /** The word of the text ends there, too. */
  readonly isWhole: boolean;
}

/** Best place where a word of the text begins so; whole words count more than the first one. */
export function placeOfWord(text: string, word: string): WordPlace | undefined {
  const lower = text.toLowerCase();
  let best: WordPlace | undefined;
  const rank = ({ isFirst, isWhole }: WordPlace): number => Number(isWhole) * 2 + Number(isFirst);
  for (let at = lower.indexOf(word); at >= 0; at = lower.indexOf(word, at + 1)) {
    if (!isWordStart(text, at)) continue;
    const end = at + word.length;
    const isWhole = end === text.length || !/[\p{L}\p{N}]/u.test(text.charAt(end));
    const place = { isFirst: at === 0, isWhole };
    if (best === undefined || rank(place) > rank(best)) best = place;
  }
  return best;
}

/** What can be searched of an entry. */
export interface Searched {
  readonly name: string;
  /** Other words for it: tags, other names. */
  readonly aliases: readonly string[];
  readonly text: string;
}

/** Points of a word, by the best place where it was found. */
const SCORES = { exact: 12, name: 10, wordOfName: 8, insideName: 6, alias: 4, text: 2 };

/** Relevance for typed words: name, word in the name, alias, text; 0: a word is missing. */
export function searchScore(searched: Searched, words: readonly string[]): number {
  let sum = 1;
  for (const word of words) {
    const score = scoreOf(searched, word);
    if (score === 0) return 0;
    sum += score;
  }
  return sum;
}

function scoreOf({ name, aliases, text }: Searched, word: string): number {
  const lower = name.toLowerCase();
  if (lower === word) return SCORES.exact;
  const place = placeOfWord(name, word);
  if (place !== undefined) return place.isFirst ? SCORES.name : SCORES.wordOfName;
  if (lower.includes(word)) return SCORES.insideName;
  if (aliases.some((alias) => placeOfWord(alias, word) !== undefined)) return SCORES.alias;
  return [text, ...aliases].some((one) => one.toLowerCase().includes(word)) ? SCORES.text : 0;
}

/** Part of a text, and whether it matches a word of the query. */
export interface MarkedPart {
  readonly text: string;
  readonly isMatch: boolean;
}

/** Cuts a text into the parts that match a word, and those between. */
export function markedParts(text: string, words: readonly string[]): MarkedPart[] {
  const lower = text.toLowerCase();
  const isMarked = Array.from<boolean>({ length: text.length }).fill(false);
  for (const word of words)
    for (let at = lower.indexOf(word); at >= 0; at = lower.indexOf(word, at + 1))
      isMarked.fill(true, at, at + word.length);
  const parts: { text: string; isMatch: boolean }[] = [];
  for (let at = 0; at < text.length; at += 1) {
    const isMatch = isMarked[at] === true;
    const last = parts.at(-1);
    if (last?.isMatch === isMatch) last.text += text.charAt(at);
    else parts.push({ text: text.charAt(at), isMatch });
  }
  return parts;
}
