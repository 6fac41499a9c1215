import { StatusProblemSeverity, type Client, type Session, type StatusProblem } from '@ubii/proto';
import type { RouteLocationRaw } from 'vue-router';
import { clientLocation } from '../clients/routes.ts';
import { sessionLocation } from '../sessions/routes.ts';
import { problemParts } from './problem-parts.ts';
import { sessionProblems } from './session-problems.ts';

/** Something that can be done about a problem right here. */
export type ProblemAction =
  | { readonly kind: 'show-qr' }
  | { readonly kind: 'throttle'; readonly clientId: string }
  | { readonly kind: 'unthrottle'; readonly clientId: string }
  | { readonly kind: 'stop-session'; readonly sessionId: string };

/** Where the thing is that has the problem. */
export interface ProblemLink {
  readonly text: string;
  readonly to: RouteLocationRaw;
}

/** One thing that is wrong, as Home shows it. */
export interface HomeProblem {
  /** Stays the same while the problem stands. */
  readonly key: string;
  readonly code: string;
  readonly isError: boolean;
  /** Whom or what it is about, when the sentence begins with that. */
  readonly subject: string | undefined;
  /** What is wrong, and what follows. */
  readonly text: string;
  /** What to do about it; empty when nobody can do anything. */
  readonly remedy: string;
  /** Master's clock, epoch milliseconds; `undefined` when nobody knows since when. */
  readonly sinceMs: number | undefined;
  readonly link: ProblemLink | undefined;
  readonly action: ProblemAction | undefined;
}

/** What the sentences are about. */
export interface ProblemContext {
  findClient(id: string): Client | undefined;
  readonly sessions: readonly Session[];
}

/** Everything that is wrong, errors first: what the master finds, and what sessions say of themselves. */
export function homeProblems(
  problems: readonly StatusProblem[],
  context: ProblemContext,
): HomeProblem[] {
  const ofMaster = problems
    // Those of sessions are told in full by the sessions
    .filter(({ code }) => code !== 'session_degraded')
    .map((problem) => ofStatus(problem, context));
  const ofSessions = sessionProblems(context.sessions).map(
    ({ session, problem }, index): HomeProblem => ({
      key: `session ${session.id} ${problem.code} ${problem.moduleId} ${index}`,
      code: problem.code,
      isError: true,
      subject: session.name,
      text: problem.message,
      remedy: '',
      sinceMs: undefined,
      link: { text: 'Open session', to: sessionLocation(session.id) },
      action: { kind: 'stop-session', sessionId: session.id },
    }),
  );
  return [...ofSessions, ...ofMaster].sort((a, b) => Number(b.isError) - Number(a.isError));
}

/** Of these there may be several, told apart by how their sentences begin. */
const IN_TEXT: ReadonlySet<string> = new Set(['limit_reached', 'file_broken']);

function ofStatus(problem: StatusProblem, { findClient }: ProblemContext): HomeProblem {
  const { code, clientId, sessionId, moduleId, severity, text, remedy, sinceMs } = problem;
  const name = clientId === '' ? undefined : findClient(clientId)?.name;
  const parts = problemParts(text, name);
  return {
    key: `${code} ${clientId} ${sessionId} ${moduleId} ${IN_TEXT.has(code) ? text.split(',', 1)[0] : ''}`,
    code,
    isError: severity === StatusProblemSeverity.ERROR,
    // A sentence about the master that names a client begins with the master
    subject: name !== undefined && text.startsWith(`${name} `) ? parts.subject : undefined,
    text: name !== undefined && text.startsWith(`${name} `) ? parts.text : text,
    remedy,
    sinceMs,
    link: linkOf(problem),
    action: actionOf(problem),
  };
}

function linkOf({ code, clientId, sessionId }: StatusProblem): ProblemLink | undefined {
  if (code === 'limit_reached') return { text: 'Open limits', to: '/settings/limits' };
  if (code === 'file_broken') return { text: 'Open log', to: '/settings/log' };
  if (sessionId !== '') return { text: 'Open session', to: sessionLocation(sessionId) };
  if (clientId !== '') return { text: 'Open client', to: clientLocation(clientId) };
  return code === 'master_busy' ? { text: 'Open clients', to: '/clients' } : undefined;
}

function actionOf({ code, clientId, sessionId }: StatusProblem): ProblemAction | undefined {
  switch (code) {
    case 'client_silent':
      return { kind: 'show-qr' };
    case 'publisher_noisy':
    case 'master_busy':
      return clientId === '' ? undefined : { kind: 'throttle', clientId };
    case 'client_throttled':
      return { kind: 'unthrottle', clientId };
    case 'module_slow':
    case 'machine_busy':
      return sessionId === '' ? undefined : { kind: 'stop-session', sessionId };
    default:
      return undefined;
  }
}
