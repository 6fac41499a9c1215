// eslint-disable-next-line no-control-regex -- control characters are what it looks for
const CONTROL_CHARACTERS = /[\u0000-\u001f\u007f-\u009f\u2028\u2029]+/g;

/** A text of others as it may stand in a line for people: without control characters, not longer than `maxLength` characters. */
export function oneLine(text: string, maxLength: number): string {
  // What is far too long is not read to its end.
  const start = text.slice(0, 4 * maxLength);
  return [...start.replace(CONTROL_CHARACTERS, ' ').trim()].slice(0, maxLength).join('');
}
