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
