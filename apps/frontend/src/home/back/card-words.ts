import type { Session } from '@ubii/proto';
import { counted } from '@ubii/words';
import {
  isWatched,
  sessionLook,
  sessionState,
  stateLook,
} from '../../sessions/state/session-state.ts';

/** Returns the sessions that Home shows as cards: they run, are paused or start. */
export const runningOf = (sessions: readonly Session[]): readonly Session[] =>
  sessions.filter(isWatched);

/** True for a session whose card has a warning. */
export const needsAttention = (session: Session): boolean =>
  sessionLook(session).mark === 'warning';

/**
 * Words below the name: its problems, which Home tells in full above, how it stands if it does not simply run, or what
 * it does.
 */
export function cardWords(session: Session): string {
  const problems = session.extension?.problems ?? [];
  const errors = problems.filter(({ isError }) => isError).length;
  if (errors > 0) return counted(errors, 'problem');
  if (needsAttention(session) && problems[0]) return problems[0].message;
  const { word, mark } = stateLook(sessionState(session));
  if (mark !== 'live') return word;
  return session.description || session.processingModules.map(({ name }) => name).join(', ');
}
