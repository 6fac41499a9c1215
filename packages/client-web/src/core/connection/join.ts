import { AccessRole, JoinProblem as WireProblem, ServiceError } from '@ubii/proto';

/**
 * Why a client is not admitted: `missing`: it has no token · `wrong`: the token is unknown · `expired`
 * · `revoked` · `used`: as many have joined with it as may · `guessing`: too many wrong codes were tried
 * · `role`: it is admitted, but not to what it asked for. [AC-12]
 */
export type JoinProblem =
  | 'missing'
  | 'wrong'
  | 'expired'
  | 'revoked'
  | 'used'
  | 'guessing'
  | 'role';

/** Rights of a client at its master. [AC-20] */
export type ClientRole = 'admin' | 'participant' | 'player' | 'viewer';

const PROBLEMS: ReadonlyMap<unknown, JoinProblem> = new Map<unknown, JoinProblem>([
  [WireProblem.JOIN_PROBLEM_MISSING, 'missing'],
  [WireProblem.JOIN_PROBLEM_WRONG, 'wrong'],
  [WireProblem.JOIN_PROBLEM_EXPIRED, 'expired'],
  [WireProblem.JOIN_PROBLEM_REVOKED, 'revoked'],
  [WireProblem.JOIN_PROBLEM_USED, 'used'],
  [WireProblem.JOIN_PROBLEM_GUESSING, 'guessing'],
  [WireProblem.JOIN_PROBLEM_ROLE, 'role'],
]);

const ROLES: ReadonlyMap<number, ClientRole> = new Map<number, ClientRole>([
  [AccessRole.ACCESS_ROLE_ADMIN, 'admin'],
  [AccessRole.ACCESS_ROLE_PARTICIPANT, 'participant'],
  [AccessRole.ACCESS_ROLE_PLAYER, 'player'],
  [AccessRole.ACCESS_ROLE_VIEWER, 'viewer'],
]);

/** Why the master does not let the client in; `undefined` when the error is about something else. */
export function joinProblemOf(error: unknown): JoinProblem | undefined {
  return error instanceof ServiceError ? PROBLEMS.get(error.details['joinProblem']) : undefined;
}

/** The problem as `join_check` says it; `undefined` when there is none. */
export function joinProblem(wire: number): JoinProblem | undefined {
  return PROBLEMS.get(wire);
}

/** `undefined` for a stranger, and with masters that know no roles. */
export function clientRole(wire: number): ClientRole | undefined {
  return ROLES.get(wire);
}

/** A token as a header can carry it; `undefined` for what is no token of any master. */
export function sendableToken(typed: string): string | undefined {
  const token = typed.trim();
  return /^[!-~][ -~]{0,199}$/.test(token) ? token : undefined;
}

/** The error for a token that no master can have given. */
export function wrongToken(): ServiceError {
  return new ServiceError('unauthenticated', 'No invitation has this code.', {
    details: { joinProblem: WireProblem.JOIN_PROBLEM_WRONG },
  });
}
