import type { Session, SessionProblem } from '@ubii/proto';
import { hasTrouble } from '../sessions/state/session-state.ts';

/** An error of a session that should run. */
export interface SessionTrouble {
  readonly session: Session;
  readonly problem: SessionProblem;
}

/** What is wrong with sessions that run, or should. */
export function sessionProblems(sessions: readonly Session[]): SessionTrouble[] {
  return sessions
    .filter(hasTrouble)
    .flatMap((session) =>
      (session.extension?.problems ?? [])
        .filter(({ isError }) => isError)
        .map((problem) => ({ session, problem })),
    );
}

/** How many modules do not do what they should; a problem of a whole session counts as one. */
export function troubledModules(sessions: readonly Session[]): number {
  const keys = sessionProblems(sessions).map(
    ({ session, problem }) => problem.moduleId || `session ${session.id}`,
  );
  return new Set(keys).size;
}
