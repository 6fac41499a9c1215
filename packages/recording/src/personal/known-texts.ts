import { parseJsonText, replaceInJson } from './json-texts.ts';
import { normalForms, normalOf, type MappedText } from './normal-form.ts';

/** A text to be found. */
export interface KnownText {
  /** Its normal form. */
  readonly normal: string;
  readonly replacement: string;
  /** A label names it. */
  isLabelled: boolean;
}

/** A known text by its words. */
interface KnownWords {
  readonly known: KnownText;
  /** What is before its first word and after its last one. */
  readonly lead: string;
  readonly trail: string;
  /** The text continues after these words: a text with them is replaced as a whole. */
  readonly isLonger: boolean;
}

interface Found {
  readonly known: KnownText;
  readonly start: number;
  readonly end: number;
}

/** Scripts without spaces between words: each letter counts as a word. */
const WITHOUT_SPACES =
  /[\p{sc=Han}\p{sc=Hiragana}\p{sc=Katakana}\p{sc=Hangul}\p{sc=Thai}\p{sc=Lao}\p{sc=Khmer}\p{sc=Myanmar}]/u;
const WORD =
  /[\p{sc=Han}\p{sc=Hiragana}\p{sc=Katakana}\p{sc=Hangul}\p{sc=Thai}\p{sc=Lao}\p{sc=Khmer}\p{sc=Myanmar}]|(?:(?![\p{sc=Han}\p{sc=Hiragana}\p{sc=Katakana}\p{sc=Hangul}\p{sc=Thai}\p{sc=Lao}\p{sc=Khmer}\p{sc=Myanmar}])[\p{L}\p{N}\p{M}])+/gu;
const ASCII = /^[\0-\x7f]*$/;
const WORD_OF_ASCII = /[a-z0-9]+/g;
/** What is longer is known by its first words. */
const MAX_WORDS = 24;
const MIN_CHARACTERS = 3;
const MIN_DIGITS = 5;
/** Short texts in which nothing was found, such as keys of JSON, come again and again. */
const MAX_REMEMBERED = 10_000;
const MAX_REMEMBERED_CHARACTERS = 64;

/** Whether a text, by its normal form, is distinctive enough to search for it in other texts. [PD-18] */
export function isTelling(normal: string): boolean {
  if (WITHOUT_SPACES.test(normal)) return normal.normalize('NFC').length >= MIN_CHARACTERS - 1;
  if (/\p{L}/u.test(normal)) return normal.length >= MIN_CHARACTERS;
  return (normal.match(/\p{N}/gu)?.length ?? 0) >= MIN_DIGITS;
}

/** Finds texts in others, however they are spelled [PD-17], and replaces them. Time does not grow with their number. */
export class KnownTexts {
  readonly #whole = new Map<string, KnownText>();
  /** By all their words. */
  readonly #byWords = new Map<string, KnownWords[]>();
  /** By their first word: how many words they have, the most first. */
  readonly #counts = new Map<string, number[]>();
  readonly #without = new Set<string>();
  /** Some are numbers. */
  #hasNumbers = false;

  /** Adds a text to be found. One that does not tell enough is found only where it is all of a text, or a level of a topic. */
  add(text: string, replacement: string, { isLabelled = false } = {}): void {
    this.#without.clear();
    for (const form of normalForms(text)) this.#add(form.text.trim(), replacement, isLabelled);
  }

  #add(normal: string, replacement: string, isLabelled: boolean): void {
    if (normal === '') return;
    const other = this.#whole.get(normal);
    if (other !== undefined) {
      other.isLabelled ||= isLabelled;
      return;
    }
    const known = { normal, replacement, isLabelled };
    this.#whole.set(normal, known);
    const words = wordsOf(normal);
    if (words.length === 0 || !isTelling(normal)) return;
    this.#hasNumbers ||= !/\p{L}/u.test(normal);
    const count = Math.min(words.length, MAX_WORDS);
    const start = words[0]!.start;
    const end = words[count - 1]!.end;
    const isLonger = count < words.length;
    const lead = normal.slice(0, start);
    const trail = isLonger ? '' : normal.slice(end);
    const all = normal.slice(start, end);
    const alike = [...(this.#byWords.get(all) ?? []), { known, lead, trail, isLonger }];
    this.#byWords.set(all, alike.sort(byLength));
    const first = normal.slice(start, words[0]!.end);
    const counts = new Set(this.#counts.get(first)).add(count);
    this.#counts.set(
      first,
      [...counts].sort((a, b) => b - a),
    );
  }

  /** Replaces known texts in a text where they are whole words; in JSON, in its texts and numbers. */
  replaceIn(text: string, onFound: (known: KnownText) => void = () => undefined): string {
    if (this.#whole.size === 0 || text === '' || this.#without.has(text)) return text;
    if (parseJsonText(text) !== undefined) {
      return replaceInJson(text, (inner, isNumber) =>
        isNumber ? this.#numberFor(inner, onFound) : this.replaceIn(inner, onFound),
      );
    }
    let result = '';
    let done = 0;
    for (const { known, start, end } of this.#find(text)) {
      onFound(known);
      result += text.slice(done, start) + known.replacement;
      done = end;
    }
    if (done > 0) return result + text.slice(done);
    if (text.length <= MAX_REMEMBERED_CHARACTERS) this.#remember(text);
    return text;
  }

  /** Replaces known texts in the levels of a topic. */
  replaceInTopic(topic: string, onFound: (known: KnownText) => void = () => undefined): string {
    const found = this.replaceIn(topic, onFound);
    const levels = found.split('/').map((level) => {
      const known = this.#whole.get(normalOf(level));
      if (known === undefined) return level;
      onFound(known);
      return known.replacement;
    });
    const shared = levels.join('/');
    return topic.startsWith('/') && !shared.startsWith('/') ? `/${shared}` : shared;
  }

  /** Whether a labelled text stands in a text. */
  hasLabelled(text: string): boolean {
    return this.#find(text).some(({ known }) => known.isLabelled);
  }

  #remember(text: string): void {
    if (this.#without.size >= MAX_REMEMBERED) this.#without.clear();
    this.#without.add(text);
  }

  #numberFor(number: string, onFound: (known: KnownText) => void): string {
    if (!this.#hasNumbers || number.length < MIN_DIGITS) return number;
    const [found] = this.#find(number, { isWhole: false });
    if (found?.start !== 0 || found.end !== number.length) return number;
    onFound(found.known);
    return found.known.replacement;
  }

  /** What is found first to last; nothing overlaps. */
  #find(text: string, { isWhole = true } = {}): Found[] {
    const found: Found[] = [];
    for (const form of normalForms(text)) {
      const known = isWhole ? this.#whole.get(form.text.trim()) : undefined;
      if (known !== undefined) return [{ known, start: 0, end: text.length }];
      for (const each of this.#findIn(form)) {
        if (each.isLonger) return [{ known: each.known, start: 0, end: text.length }];
        found.push(each);
      }
    }
    return joined(found.sort((a, b) => a.start - b.start || b.end - a.end));
  }

  *#findIn(form: MappedText): Generator<Found & { readonly isLonger: boolean }> {
    const { text } = form;
    const words = wordsOf(text);
    for (let place = 0; place < words.length; place++) {
      const { start, end } = words[place]!;
      for (const count of this.#counts.get(text.slice(start, end)) ?? []) {
        const last = words[place + count - 1];
        const alike = last && this.#byWords.get(text.slice(start, last.end));
        const match = alike?.find(
          ({ lead, trail }) =>
            text.startsWith(lead, start - lead.length) && text.startsWith(trail, last!.end),
        );
        if (match === undefined) continue;
        const { known, lead, trail, isLonger } = match;
        const from = form.startOf(start - lead.length);
        yield { known, isLonger, start: from, end: form.endOf(last!.end + trail.length - 1) };
        place += count - 1;
        break;
      }
    }
  }
}

function wordsOf(text: string): { readonly start: number; readonly end: number }[] {
  const pattern = ASCII.test(text) ? WORD_OF_ASCII : WORD;
  return Array.from(text.matchAll(pattern), ({ 0: word, index }) => ({
    start: index,
    end: index + word.length,
  }));
}

/** Joins what overlaps in several forms of a text. */
function joined(found: readonly Found[]): Found[] {
  const apart: Found[] = [];
  for (const each of found) {
    const last = apart.at(-1);
    if (last === undefined || each.start >= last.end) apart.push(each);
    else if (each.end > last.end) apart[apart.length - 1] = { ...last, end: each.end };
  }
  return apart;
}

function byLength(a: KnownWords, b: KnownWords): number {
  return b.lead.length + b.trail.length - a.lead.length - a.trail.length;
}
