/** Returns a text with its first letter as a capital. */
export function capitalised(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

const rules = /* @__PURE__ */ new Intl.PluralRules('en');

/**
 * Returns the form of a word, or of a part of a sentence, for a number of things.
 *
 * @param one form for 1
 * @param other form for 0, 2 and more, and fractions; by default `one` with an s
 */
export function plural(number: number, one: string, other = `${one}s`): string {
  return rules.select(number) === 'one' ? one : other;
}

/** Returns a number with its noun: `1 session`, `3 sessions`. Parameters as those of `plural`. */
export function counted(number: number, one: string, other?: string): string {
  return `${number} ${plural(number, one, other)}`;
}

/** Whether the text takes more than `maxBytes` in UTF-8. */
export function isLongerThan(text: string, maxBytes: number): boolean {
  // A UTF-16 unit takes one to three bytes, so that the length alone mostly answers.
  if (text.length > maxBytes) return true;
  if (text.length * 3 <= maxBytes) return false;
  let byteLength = 0;
  for (const char of text) {
    const code = char.codePointAt(0)!;
    byteLength += code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
  }
  return byteLength > maxBytes;
}

/** Whether the text has more than `max` characters: code points, as people count them. */
export function hasMoreCharacters(text: string, max: number): boolean {
  // A character takes one or two UTF-16 units, so that the length alone mostly answers.
  if (text.length <= max) return false;
  return text.length > 2 * max || [...text].length > max;
}

/** The first `max` characters of a text. */
export function firstCharacters(text: string, max: number): string {
  if (text.length <= max) return text;
  // Do not read the whole of a text that is far too long.
  return [...text.slice(0, 2 * max)].slice(0, max).join('');
}

/** The text, or as much of it as `max` characters hold with an ellipsis at its end. */
export function shortened(text: string, max: number): string {
  return hasMoreCharacters(text, max) ? `${firstCharacters(text, max - 1)}…` : text;
}

/** Control characters, ends of lines, and what turns the direction of the text that follows. */
const UNPRINTABLE =
  // eslint-disable-next-line no-control-regex -- control characters are what it looks for
  /[\u0000-\u001f\u007f-\u009f\u2028\u2029\u202a-\u202e\u2066-\u2069]+/g;

/** A text of others as it may stand in a line for people: without control characters, not longer than `maxLength` characters. */
export function oneLine(text: string, maxLength: number): string {
  // Do not read the whole of a text that is far too long.
  const start = text.slice(0, 4 * maxLength);
  return firstCharacters(start.replace(UNPRINTABLE, ' ').trim(), maxLength);
}

/** Whether the text may stand in a line for people as it is. */
export function isOneLine(text: string): boolean {
  return text.search(UNPRINTABLE) < 0;
}

/** Escapes a CSV field; texts that spreadsheets would evaluate as a formula are quoted as text. */
export function csvField(value: string): string {
  const text = /^[=+@\t\r-]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
