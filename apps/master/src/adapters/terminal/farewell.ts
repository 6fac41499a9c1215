import type { SessionsAtStop } from '../../core/sessions/restored-sessions.ts';
import { countSessions, listNames } from './session-words.ts';

/** Returns the last lines that a master writes in the terminal: which sessions start again with it, and which end [SE-24]. */
export function formatFarewell({ startAgain, end }: SessionsAtStop): string {
  return [
    'Stopped.',
    ...(startAgain.length === 0
      ? []
      : [
          `${countSessions(startAgain)} will start again with the master: ${listNames(startAgain)}`,
        ]),
    ...(end.length === 0
      ? []
      : [
          `${countSessions(end)} ended and will not start again: ${listNames(end)}`,
          `An open page of an example starts its own session again. For others, turn on "Resume when the master restarts".`,
        ]),
  ].join('\n');
}
