import { firstCharacters } from './text-length.ts';

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
