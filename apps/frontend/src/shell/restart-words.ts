import type { Session } from '@ubii/proto';
import { isAlive } from '../sessions/state/session-state.ts';

type Living = Pick<Session, 'name' | 'status' | 'extension'>;

/** How many sessions are named. */
const MAX_NAMES = 2;

/** The sessions that run, by name: a page of an example starts its own again under another id. */
export function runningNames(sessions: readonly Living[]): string[] {
  return sessions.filter(isAlive).map(({ name }) => name);
}

/**
 * What became of the sessions that ran before the master was restarted; empty when none ran.
 * @param before names of those that ran
 * @param now the sessions of the master that was restarted
 */
export function afterRestart(before: readonly string[], now: readonly Living[]): string {
  const left = runningNames(now);
  const again: string[] = [];
  const ended: string[] = [];
  for (const name of before) {
    const index = left.indexOf(name);
    if (index >= 0) left.splice(index, 1);
    (index < 0 ? ended : again).push(name);
  }
  return [
    ...(again.length > 0
      ? [`${subject(again)} ${again.length === 1 ? 'runs' : 'run'} again.`]
      : []),
    ...(ended.length > 0
      ? [`${subject(ended)} ${ended.length === 1 ? 'does' : 'do'} not run.`]
      : []),
  ].join(' ');
}

/** `“Hands”`, `“Hands” and “Mirror”`, `3 sessions`. */
function subject(names: readonly string[]): string {
  if (names.length > MAX_NAMES) return `${names.length} sessions`;
  return names.map((name) => `“${name || 'Session without a name'}”`).join(' and ');
}
