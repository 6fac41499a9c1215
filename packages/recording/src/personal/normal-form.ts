interface Edit {
  readonly at: number;
  readonly found: string;
  readonly put: string;
}

/** First places of characters, and places after their last ones. */
interface Places {
  readonly starts: Uint32Array;
  readonly ends: Uint32Array;
}

/** A text, and for each of its characters the part of the text that it was made of. */
export class MappedText {
  readonly text: string;
  /** Undefined while all characters stand where they stood. */
  readonly #places: Places | undefined;

  private constructor(text: string, places: Places | undefined) {
    this.text = text;
    this.#places = places;
  }

  static of(text: string): MappedText {
    return new MappedText(text, undefined);
  }

  /** Place in the original of the beginning of a character. */
  startOf(index: number): number {
    return this.#places === undefined ? index : this.#places.starts[index]!;
  }

  /** Place in the original after the end of a character. */
  endOf(index: number): number {
    return this.#places === undefined ? index + 1 : this.#places.ends[index]!;
  }

  /** Replaces what a pattern finds. @returns itself when nothing changes */
  rewritten(pattern: RegExp, replace: (found: string) => string): MappedText {
    const edits: Edit[] = [];
    for (const { 0: found, index: at } of this.text.matchAll(pattern)) {
      const put = replace(found);
      if (put !== found) edits.push({ at, found, put });
    }
    if (edits.length === 0) return this;
    const text = this.#textWith(edits);
    const isMoved = edits.some(({ found, put }) => found.length !== put.length);
    return new MappedText(text, isMoved ? this.#placesWith(edits, text.length) : this.#places);
  }

  #textWith(edits: readonly Edit[]): string {
    const parts: string[] = [];
    let done = 0;
    for (const { at, found, put } of edits) {
      parts.push(this.text.slice(done, at), put);
      done = at + found.length;
    }
    parts.push(this.text.slice(done));
    return parts.join('');
  }

  #placesWith(edits: readonly Edit[], length: number): Places {
    const starts = new Uint32Array(length);
    const ends = new Uint32Array(length);
    let to = 0;
    let from = 0;
    const keepUntil = (end: number): void => {
      for (; from < end; from++, to++) {
        starts[to] = this.startOf(from);
        ends[to] = this.endOf(from);
      }
    };
    for (const { at, found, put } of edits) {
      keepUntil(at);
      const after = at + found.length;
      starts.fill(this.startOf(at), to, to + put.length);
      ends.fill(this.endOf(after - 1), to, to + put.length);
      to += put.length;
      from = after;
    }
    keepUntil(this.text.length);
    return { starts, ends };
  }
}

/** Times that a text is decoded: escapes in escapes, and a third time to be sure. */
const MAX_DECODINGS = 3;

const CODE_ESCAPES = /\\u\{[\da-f]{1,6}\}|\\u[\da-f]{4}|\\x[\da-f]{2}|\\[nrtbf"'\\/]/gi;
const ENTITIES = /&#\d{1,7};|&#x[\da-f]{1,6};|&(?:amp|lt|gt|quot|apos|nbsp);/gi;
/** A character of UTF-8, or else of Latin-1. */
const URL_ESCAPES =
  /%[0-7][\da-f]|%[cd][\da-f]%[89ab][\da-f]|%e[\da-f](?:%[89ab][\da-f]){2}|%f[0-7](?:%[89ab][\da-f]){3}|%[89a-f][\da-f]/gi;
const NAMED: Readonly<Record<string, string>> = {
  '\\n': '\n',
  '\\r': '\r',
  '\\t': '\t',
  '\\b': '\b',
  '\\f': '\f',
  '&amp;': '&',
  '&lt;': '<',
  '&gt;': '>',
  '&quot;': '"',
  '&apos;': "'",
  '&nbsp;': ' ',
};

/** A letter that is not ASCII, or has marks, with its marks. */
const LETTERS = /[^\0-\x7f]\p{M}*|[\0-\x7f]\p{M}+/gu;
/** Accents of Latin, Greek and Cyrillic letters, and what is not seen, such as soft hyphens. */
const UNSEEN = /[\u0300-\u036f]|\p{Default_Ignorable_Code_Point}/gu;
const APOSTROPHES = /[\u2018\u2019\u02bc\u00b4]/g;
const SEPARATORS = /[\s\p{Z}\p{Pd}\p{Pc}+.]+/gu;
/** Of texts in ASCII, of which most records are. */
const ASCII_SEPARATORS = /[\s_+.-]+/g;
const ASCII = /^[\0-\x7f]*$/;
const ESCAPE_SIGNS = /[\\%&]/;

/** The normal form of a text: two spellings of [PD-17] have the same one. */
export function normalOf(text: string): string {
  return folded(MappedText.of(text)).text.trim();
}

/** The normal form of a text as it is, and as it is when what is escaped in it is decoded. */
export function* normalForms(text: string): Generator<MappedText> {
  let form = MappedText.of(text);
  for (let decodings = 0; ; decodings++) {
    yield folded(form);
    if (decodings === MAX_DECODINGS || !ESCAPE_SIGNS.test(form.text)) return;
    const next = decoded(form);
    if (next === form) return;
    form = next;
  }
}

/** Compatible letters without case and accents, and one space for what separates words. */
function folded(text: MappedText): MappedText {
  const isAscii = ASCII.test(text.text);
  const letters = isAscii ? text : text.rewritten(LETTERS, foldedLetter);
  return letters
    .rewritten(/[A-Z]+/g, (capitals) => capitals.toLowerCase())
    .rewritten(isAscii ? ASCII_SEPARATORS : SEPARATORS, () => ' ');
}

function foldedLetter(letter: string): string {
  const plain = letter.replace(APOSTROPHES, "'").normalize('NFKD');
  // Upper case first: "ß" is "SS" there.
  return plain.toUpperCase().toLowerCase().normalize('NFKD').replace(UNSEEN, '');
}

function decoded(text: MappedText): MappedText {
  return text
    .rewritten(CODE_ESCAPES, decodedCode)
    .rewritten(ENTITIES, decodedCode)
    .rewritten(URL_ESCAPES, decodedUrl);
}

function decodedCode(escape: string): string {
  const named = NAMED[escape.toLowerCase()];
  if (named !== undefined) return named;
  const hex = /^(?:\\[ux]\{?|&#x)([\da-f]+)/i.exec(escape)?.[1];
  const decimal = /^&#(\d+)/.exec(escape)?.[1];
  if (hex === undefined && decimal === undefined) return escape.slice(1);
  const code = hex === undefined ? Number(decimal) : parseInt(hex, 16);
  return code <= 0x10ffff ? String.fromCodePoint(code) : escape;
}

function decodedUrl(escape: string): string {
  try {
    return decodeURIComponent(escape);
  } catch {
    return escape.replace(/%(..)/g, (_, hex: string) => String.fromCharCode(parseInt(hex, 16)));
  }
}
