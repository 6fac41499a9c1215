/** A text to be found. */
interface Known {
  readonly text: string;
  readonly replacement: string;
  /** Characters of it before its first word. */
  readonly lead: number;
}

const WORD = /[\p{L}\p{N}]+/gu;
const WORD_CHARACTER = /[\p{L}\p{N}]/u;
/** Shorter ones are replaced only where they are the whole text or a level of a topic: they are in any sentence. */
const MIN_SEARCHED_CHARACTERS = 3;

/** Finds names and ids in texts, and replaces them. Time does not grow with their number. */
export class KnownTexts {
  readonly #whole = new Map<string, string>();
  /** By their first word, the longest first. */
  readonly #byWord = new Map<string, Known[]>();

  /** Adds a text to be found, whatever the case of its letters. */
  add(text: string, replacement: string): void {
    const key = fold(text);
    if (text === '' || this.#whole.has(key)) return;
    this.#whole.set(key, replacement);
    const first = key.match(WORD)?.[0];
    if (first === undefined || key.length < MIN_SEARCHED_CHARACTERS) return;
    const known = { text: key, replacement, lead: key.indexOf(first) };
    const others = [...(this.#byWord.get(first) ?? []), known];
    this.#byWord.set(
      first,
      others.sort((a, b) => b.text.length - a.text.length),
    );
  }

  /** Replaces known texts in a text where they are whole words. */
  replaceIn(text: string): string {
    const folded = fold(text);
    const whole = this.#whole.get(folded);
    if (whole !== undefined) return whole;
    let result = '';
    let done = 0;
    for (const { 0: word, index } of folded.matchAll(WORD)) {
      if (index < done) continue;
      const found = this.#byWord.get(word)?.find((known) => isAt(known, folded, index, done));
      if (found === undefined) continue;
      const start = index - found.lead;
      result += text.slice(done, start) + found.replacement;
      done = start + found.text.length;
    }
    return done === 0 ? text : result + text.slice(done);
  }

  /** Replaces known texts in the levels of a topic. */
  replaceInTopic(topic: string): string {
    const found = this.replaceIn(topic);
    return found
      .split('/')
      .map((level) => this.#whole.get(fold(level)) ?? level)
      .join('/');
  }
}

function isAt({ text, lead }: Known, folded: string, index: number, done: number): boolean {
  const start = index - lead;
  const end = start + text.length;
  if (start < done || !folded.startsWith(text, start)) return false;
  return !(WORD_CHARACTER.test(text.at(-1)!) && WORD_CHARACTER.test(folded[end] ?? ''));
}

/** Lower case, character by character, so that places stay the same. */
function fold(text: string): string {
  const lower = text.toLowerCase();
  return lower.length === text.length
    ? lower
    : text.replace(/[^]/g, (character) => {
        const small = character.toLowerCase();
        return small.length === 1 ? small : character;
      });
}
