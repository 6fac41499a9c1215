import type { Session } from '@ubii/proto';
import { counted, plural } from '@ubii/words';
import { isAlive } from '../../sessions/state/session-state.ts';

/** Names of the running sessions in words; `undefined` without any. */
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

/** Describes which running sessions continue with the saved code; `undefined` when none is running. [SE-26] */
export function savedNote(users: readonly Session[]): string | undefined {
  const who = runningWords(users);
  if (who === undefined) return undefined;
  const verb = plural(users.filter(isAlive).length, 'runs', 'run');
  return `${who} ${verb} the new code.`;
}
