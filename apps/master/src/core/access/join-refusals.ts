import { JoinProblem, ServiceError, type ServiceErrorCode } from '@ubii/proto';

/** When a code that was not looked at may be. */
const RETRY_AFTER_S = 1;

interface Sentence {
  readonly code: ServiceErrorCode;
  readonly message: string;
}

const HOW = 'Scan the QR code of this master, or type its code on its page /join.';

/** Messages for callers that cannot join [AC-12]. */
const SENTENCES: { readonly [P in JoinProblem]?: Sentence } = {
  [JoinProblem.JOIN_PROBLEM_MISSING]: {
    code: 'unauthenticated',
    message: `This device has not joined yet. ${HOW}`,
  },
  [JoinProblem.JOIN_PROBLEM_WRONG]: {
    code: 'unauthenticated',
    message: `No invitation has this code. ${HOW}`,
  },
  [JoinProblem.JOIN_PROBLEM_EXPIRED]: {
    code: 'unauthenticated',
    message: 'This code expired. Ask for a new one, then scan or type it.',
  },
  [JoinProblem.JOIN_PROBLEM_REVOKED]: {
    code: 'unauthenticated',
    message: 'The invitation was revoked. Ask for a new code, then scan or type it.',
  },
  [JoinProblem.JOIN_PROBLEM_USED]: {
    code: 'unauthenticated',
    message:
      'This code has been used as often as its invitation allows. Ask for a new one, then scan or type it.',
  },
  [JoinProblem.JOIN_PROBLEM_GUESSING]: {
    code: 'resource_exhausted',
    message:
      'Too many wrong codes were received from this network. Try again in a moment, or scan the QR code, which works at once.',
  },
};

/** Returns the error of a refused join, with a message and a code. */
export function joinRefusal(problem: JoinProblem): ServiceError {
  const { code, message } = SENTENCES[problem] ?? SENTENCES[JoinProblem.JOIN_PROBLEM_MISSING]!;
  return new ServiceError(code, message, {
    title: 'Join first',
    details: {
      joinProblem: problem,
      ...(problem === JoinProblem.JOIN_PROBLEM_GUESSING && { retryAfterS: RETRY_AFTER_S }),
    },
  });
}

/** Returns the error of a joined caller without the right for a service [AC-21]. `message` names the right. */
export function roleRefusal(message: string): ServiceError {
  return new ServiceError('permission_denied', message, {
    details: { joinProblem: JoinProblem.JOIN_PROBLEM_ROLE },
  });
}
