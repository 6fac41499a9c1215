import type { Session } from '@ubii/proto';
import { plural } from '@ubii/words';
import { isAlive } from '../sessions/state/session-state.ts';

type Living = Pick<Session, 'name' | 'status' | 'extension'>;

/** Most sessions that are named. */
const MAX_NAMES = 2;

/** Names of running sessions: example pages restart theirs under another id. */
export function runningNames(sessions: readonly Living[]): string[] {
  return sessions.filter(isAlive).map(({ name }) => name);
}

/**
 * Describes the state of previously running sessions after a restart of the master; empty if there were none.
 * Distinguishes sessions started by the master and by pages, because the terminal of the master counts its own. [SE-24]
 * @param before names of previously running sessions
 * @param now sessions of the restarted master
 */
export function afterRestart(before: readonly string[], now: readonly Living[]): string {
  const left = now.filter(isAlive);
  const byMaster: string[] = [];
  const byPages: string[] = [];
  const ended: string[] = [];
  for (const name of before) {
    const index = left.findIndex((one) => one.name === name);
    const [again] = index < 0 ? [] : left.splice(index, 1);
    if (again === undefined) ended.push(name);
    else (again.extension?.startWithMaster === true ? byMaster : byPages).push(name);
  }
  const pages = plural(byPages.length, 'An open page', 'Open pages');
  return [
    ...(byMaster.length > 0 ? [`The master started ${namesOf(byMaster)} again.`] : []),
    ...(byPages.length > 0 ? [`${pages} started ${namesOf(byPages)} again.`] : []),
    ...(ended.length > 0
      ? [`${namesOf(ended)} ${plural(ended.length, 'does', 'do')} not run.`]
      : []),
  ].join(' ');
}

/** Formats names: `“Hands”`, `“Hands” and “Mirror”`, `3 sessions`. */
function namesOf(names: readonly string[]): string {
  if (names.length > MAX_NAMES) return `${names.length} sessions`;
  return names.map((name) => `“${name || 'Session without a name'}”`).join(' and ');
}
