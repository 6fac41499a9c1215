import type { SessionsAtStop } from '../../core/sessions/restored-sessions.ts';
import { countSessions, listNames } from './session-words.ts';

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
