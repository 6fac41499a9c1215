import type { Session } from '@ubii/proto';
import { isAlive } from '../../sessions/state/session-state.ts';

/** What saving does, for people: which running sessions go on with the new code. [SE-26] */
export function savedWords(name: string, users: readonly Session[]): string {
  const running = users
    .filter(isAlive)
    .map((session) => session.name || 'a session without a name');
  if (running.length === 0) return `Saved ${name}`;
  const [first, second, ...more] = running;
  const who =
    more.length > 0
      ? `${first} and ${more.length + 1} more`
      : [first, second].filter(Boolean).join(' and ');
  return `Saved ${name}. ${who} ${running.length === 1 ? 'goes' : 'go'} on with it`;
}
