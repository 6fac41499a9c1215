import type { Session } from '@ubii/proto';
import { counted, plural } from '@ubii/words';
import { isAlive } from '../../sessions/state/session-state.ts';

/** Names the sessions that run, in words; `undefined` when none does. */
export function runningWords(users: readonly Session[]): string | undefined {
  const running = users
    .filter(isAlive)
    .map((session) => session.name || 'a session without a name');
  const [first, second, ...more] = running;
  if (first === undefined) return undefined;
  return more.length > 0
    ? `${first} and ${more.length + 1} more`
    : [first, second].filter(Boolean).join(' and ');
}

export const errorWords = (errors: number): string => counted(errors, 'error');

/** What saving does, for people: which running sessions continue with the new code; `undefined` when none runs. [SE-26] */
export function savedNote(users: readonly Session[]): string | undefined {
  const who = runningWords(users);
  if (who === undefined) return undefined;
  const verb = plural(users.filter(isAlive).length, 'runs', 'run');
  return `${who} ${verb} the new code.`;
}
