import { counted, oneLine } from '@ubii/words';

/** Names that one line lists. */
export const MAX_NAMES = 6;
const MAX_NAME_CHARACTERS = 48;

/** A text of clients as the terminal may show it. */
export function printable(text: string, maxCharacters: number): string {
  const line = oneLine(text, maxCharacters);
  return line.length < text.trim().length ? `${line}…` : line;
}

/** `1 session` · `3 sessions` */
export function countSessions(names: readonly string[]): string {
  return counted(names.length, 'session');
}

/** `"Hands", "Mirror" and 3 more` */
export function listNames(names: readonly string[]): string {
  const shown = names
    .slice(0, MAX_NAMES)
    .map((name) => `"${printable(name, MAX_NAME_CHARACTERS)}"`);
  const more = names.length - shown.length;
  return more === 0 ? shown.join(', ') : `${shown.join(', ')} and ${more} more`;
}
