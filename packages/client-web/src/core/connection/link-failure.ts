import { ServiceError } from '@ubii/proto';
import { ConnectionError, type ConnectionErrorReason } from './connection-error.ts';
import { joinProblemOf } from './join.ts';

/** Why a link ended, or did not come about. */
export interface LinkFailure {
  readonly error: ConnectionError;
  /** WebSocket close code; 1006 when the link broke, never came up or fell silent. */
  readonly code: number;
  /** Whether the master ever answered, or the socket opened where answers cannot be asked for. */
  readonly wasUp: boolean;
}

/** Reaction of the client to a failure. */
export type Remedy = 'stop' | 'register-as-new' | 'register-again' | 'retry';

/** No close code of the master: the link broke. */
export const BROKEN = 1006;

/** Close code of a client that leaves permanently. [EX-55] */
export const LEFT = { code: 4000, reason: 'left' } as const;

/** Reactions to the close codes of the master [EX-5]; after other codes, the client reconnects with back-off. */
const REMEDIES: ReadonlyMap<number, Remedy> = new Map([
  [4001, 'stop'], // superseded: trying again would take the identity back, and so on forever
  [4003, 'register-as-new'], // not this client
  [4004, 'register-again'], // unknown client
  [4010, 'stop'], // disconnected by an admin [EX-30]
  [4011, 'stop'], // revoked: it has to join again [AC-15]
  [4012, 'stop'], // the time of what it joined with is over [AC-91]
  [1000, 'register-again'], // deregistered, on whose behalf ever [CL-16]
]);

/** An admin removed this client [EX-30]. */
const DISCONNECTED = 4010;

/** Its invitation was revoked [AC-15]. */
const REVOKED = 4011;

/** Its invitation expired [AC-91]. */
const EXPIRED = 4012;

/** Close codes that have a reason of their own. */
const REASONS: ReadonlyMap<number, ConnectionErrorReason> = new Map([
  [4001, 'superseded'],
  [DISCONNECTED, 'disconnected'],
  [REVOKED, 'join'],
  [EXPIRED, 'join'],
]);

/** Errors of a registration that trying again does not cure. */
const FINAL_CODES: ReadonlySet<string> = new Set([
  'invalid_argument',
  'permission_denied',
  'unauthenticated',
  'unimplemented',
]);

/** Reaction to a failure. */
export function remedyFor({ code, error, wasUp }: LinkFailure): Remedy {
  const remedy = REMEDIES.get(code);
  if (remedy !== undefined) return remedy;
  if (error.reason === 'join') return 'stop'; // a person has to do something
  if (error.cause instanceof ServiceError) {
    if (FINAL_CODES.has(error.cause.code)) return 'stop';
    if (isUnknownClient(error.cause)) return 'register-again';
  }
  // A socket that opens and then says nothing: whatever is there now does not know us.
  if (!wasUp && error.reason === 'timeout') return 'register-again';
  return 'retry';
}

/** The master itself replied with what to do, so that there is nothing to wait for. */
export function isTold({ code, error }: LinkFailure): boolean {
  return REMEDIES.has(code) || isUnknownClient(error.cause);
}

/** True when the master was reachable: the link was open, or the master sent a message or a reply. */
export function isAnswered({ code, error, wasUp }: LinkFailure): boolean {
  return wasUp || code !== BROKEN || error.cause instanceof ServiceError;
}

/** Returns the error of the master for an unknown client. */
export function unknownClient(cause?: unknown): ServiceError {
  return new ServiceError('not_found', 'The master does not know this client', { cause });
}

/** Whether this is the answer to a client the master does not know. */
export function isUnknownClient(error: unknown): error is ServiceError {
  return error instanceof ServiceError && error.code === 'not_found';
}

/** The failure that a close code stands for. */
export function failureOfClose(code: number, reason: string, wasUp: boolean): LinkFailure {
  const why = reason === '' ? '' : `: ${reason}`;
  const message =
    code === DISCONNECTED
      ? `This client was disconnected ${reason}`.trim()
      : code === REVOKED
        ? `The invitation was revoked ${reason}`.trim()
        : code === EXPIRED
          ? 'The invitation expired'
          : code === BROKEN
            ? `The connection to the master was lost${why}`
            : `The master closed the connection with code ${code}${why}`;
  const error = new ConnectionError(REASONS.get(code) ?? 'closed', message, {
    ...(code === REVOKED && { joinProblem: 'revoked' as const }),
    ...(code === EXPIRED && { joinProblem: 'expired' as const }),
  });
  return { error, code, wasUp };
}

/** Turns what an attempt threw into a failure. */
export function failureOf(cause: unknown): LinkFailure {
  if (isLinkFailure(cause)) return cause;
  if (cause instanceof ConnectionError) return { error: cause, code: BROKEN, wasUp: false };
  const error = ServiceError.from(cause);
  const joinProblem = joinProblemOf(error);
  if (joinProblem !== undefined) {
    const refusal = new ConnectionError('join', error.message, { cause: error, joinProblem });
    return { error: refusal, code: BROKEN, wasUp: false };
  }
  return {
    error: new ConnectionError('refused', `The master refused the client: ${error.message}`, {
      cause: error,
    }),
    code: BROKEN,
    wasUp: false,
  };
}

function isLinkFailure(cause: unknown): cause is LinkFailure {
  return typeof cause === 'object' && cause !== null && 'wasUp' in cause;
}
