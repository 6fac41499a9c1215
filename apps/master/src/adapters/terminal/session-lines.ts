import { counted, oneLine } from '@ubii/words';
import type { SessionsAtStop, RestoreReport } from '../../core/sessions/restored-sessions.ts';

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
function listNames(names: readonly string[]): string {
  const shown = names
    .slice(0, MAX_NAMES)
    .map((name) => `"${printable(name, MAX_NAME_CHARACTERS)}"`);
  const more = names.length - shown.length;
  return more === 0 ? shown.join(', ') : `${shown.join(', ')} and ${more} more`;
}

/** Returns the last lines that a master writes in the terminal: which sessions the next master starts again, and which it does not [SE-24]. */
export function formatFarewell({ startAgain, end }: SessionsAtStop): string {
  return [
    'Stopped.',
    ...(startAgain.length === 0
      ? []
      : [`The master will start ${countSessions(startAgain)} again: ${listNames(startAgain)}`]),
    ...(end.length === 0
      ? []
      : [
          `The master will not start ${countSessions(end)} again: ${listNames(end)}`,
          'A page that stays open, such as an example, starts its own session again. For other sessions, turn on "Resume when the master restarts".',
        ]),
  ].join('\n');
}

const MAX_REASON_CHARACTERS = 240;

/** Returns the lines on the sessions that this master started again, with a reason for each that does not run [SE-24]. */
export function formatRestored({ running, others }: RestoreReport): string {
  const lines = [
    ...(running.length === 0
      ? []
      : [`The master started ${countSessions(running)} again: ${listNames(running)}`]),
    ...others
      .slice(0, MAX_NAMES)
      .map(
        ({ name, reason }) =>
          `${listNames([name])} does not run as before: ${printable(reason, MAX_REASON_CHARACTERS)}`,
      ),
    ...(others.length > MAX_NAMES
      ? [`${others.length - MAX_NAMES} more do not run as before. The Sessions page lists them.`]
      : []),
  ];
  return lines.map((line) => `  ${line}\n`).join('');
}
