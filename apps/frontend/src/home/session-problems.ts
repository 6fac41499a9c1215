import type { Session, SessionProblem } from '@ubii/proto';
import { hasTrouble } from '../sessions/state/session-state.ts';

/** An error of a session that runs or is starting. */
export interface SessionTrouble {
  readonly session: Session;
  readonly problem: SessionProblem;
}

/** Returns the errors of sessions that run or are starting. */
export function sessionProblems(sessions: readonly Session[]): SessionTrouble[] {
  return sessions
    .filter(hasTrouble)
    .flatMap((session) =>
      (session.extension?.problems ?? [])
        .filter(({ isError }) => isError)
        .map((problem) => ({ session, problem })),
    );
}

/** Returns the number of modules with an error; an error of a whole session counts as one. */
export function troubledModules(sessions: readonly Session[]): number {
  const keys = sessionProblems(sessions).map(
    ({ session, problem }) => problem.moduleId || `session ${session.id}`,
  );
  return new Set(keys).size;
}
