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
