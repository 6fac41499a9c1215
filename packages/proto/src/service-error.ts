import type { ErrorMessage, JoinProblem, SessionProblem } from './generated/messages.ts';

/** The closed list of reasons for which a request or a record is refused. */
export const SERVICE_ERROR_CODES = [
  'invalid_argument',
  'failed_precondition',
  'permission_denied',
  'unauthenticated',
  'not_found',
  'already_exists',
  'resource_exhausted',
  'internal',
  'unimplemented',
  'unavailable',
  'deadline_exceeded',
] as const;

/** Why a request cannot be fulfilled. */
export type ServiceErrorCode = (typeof SERVICE_ERROR_CODES)[number];

const CODES: ReadonlySet<string> = new Set(SERVICE_ERROR_CODES);

/** A few words for people, shown above the message. */
const TITLES: { readonly [C in ServiceErrorCode]: string } = {
  invalid_argument: 'Invalid request',
  failed_precondition: 'Not possible now',
  permission_denied: 'Not allowed',
  unauthenticated: 'Not identified',
  not_found: 'Not found',
  already_exists: 'Already exists',
  resource_exhausted: 'Limit reached',
  internal: 'Internal error',
  unimplemented: 'Not implemented',
  unavailable: 'Not available',
  deadline_exceeded: 'Took too long',
};

/** Optional members of a `ServiceError` besides its code and message. */
export interface ServiceErrorOptions {
  /** A few words; default: the title of the code. */
  readonly title?: string;
  /**
   * Facts for programs, for example the name of the member that is wrong. Stay in the process, except
   * `problems`, the list of `SessionProblem`s of a session that was refused [EX-24], and `joinProblem`,
   * the reason for a refused join, a `JoinProblem` [AC-12].
   */
  readonly details?: Readonly<Record<string, unknown>>;
  readonly cause?: unknown;
}

/** A request or a record that cannot be fulfilled. The message is one sentence that says what to do. */
export class ServiceError extends Error {
  override readonly name = 'ServiceError';
  readonly code: ServiceErrorCode;
  readonly title: string;
  readonly details: Readonly<Record<string, unknown>>;

  constructor(code: ServiceErrorCode, message: string, options: ServiceErrorOptions = {}) {
    super(message, options.cause === undefined ? undefined : { cause: options.cause });
    this.code = code;
    this.title = options.title ?? TITLES[code];
    this.details = options.details ?? {};
  }

  /**
   * Turns whatever was thrown into a `ServiceError`. Errors that are not ours become `internal` with
   * a sentence that gives nothing of them away; the original is the `cause`, for the log.
   */
  static from(thrown: unknown): ServiceError {
    if (thrown instanceof ServiceError) return thrown;
    if (thrown instanceof Error && thrown.name === 'DecodeError') {
      return new ServiceError('invalid_argument', `${thrown.message}.`, { cause: thrown });
    }
    return new ServiceError(
      'internal',
      'The request failed because of an internal error of the master. See the log of the master.',
      { cause: thrown },
    );
  }

  /** The message for the wire. The stack never leaves the process. [SV-5] */
  toWire(): ErrorMessage {
    const { problems, joinProblem } = this.details;
    return {
      title: this.title,
      message: this.message,
      stack: '',
      code: this.code,
      problems: Array.isArray(problems) ? (problems as SessionProblem[]) : [],
      join: typeof joinProblem === 'number' ? { problem: joinProblem as JoinProblem } : undefined,
    };
  }

  /**
   * Reads an error of a master. Original masters send no code: theirs is `internal`.
   */
  static fromWire(
    error: Omit<ErrorMessage, 'problems' | 'join'> & Partial<ErrorMessage>,
  ): ServiceError {
    const code = isServiceErrorCode(error.code) ? error.code : 'internal';
    const message = error.message.trim() || error.title.trim() || 'The master reported no reason.';
    return new ServiceError(code, message, {
      ...(error.title === '' ? {} : { title: error.title }),
      details: {
        ...((error.problems ?? []).length === 0 ? {} : { problems: error.problems }),
        ...(error.join === undefined ? {} : { joinProblem: error.join.problem }),
      },
    });
  }
}

/** True for a code of the closed list. */
export function isServiceErrorCode(text: string): text is ServiceErrorCode {
  return CODES.has(text);
}
