import { StatusProblemSeverity, type Client, type Session, type StatusProblem } from '@ubii/proto';
import type { RouteLocationRaw } from 'vue-router';
import { clientLocation } from '../locations/client-location.ts';
import { sessionLocation } from '../locations/session-location.ts';
import { problemParts } from './problem-parts.ts';
import { sessionProblems } from './session-problems.ts';

/** An action against a problem, offered beside it. */
export type ProblemAction =
  | { readonly kind: 'show-qr' }
  | { readonly kind: 'throttle'; readonly clientId: string }
  | { readonly kind: 'unthrottle'; readonly clientId: string }
  | { readonly kind: 'stop-session'; readonly sessionId: string };

/** The page of the client or session that has the problem. */
export interface ProblemLink {
  readonly text: string;
  readonly to: RouteLocationRaw;
}

/** A problem in the form shown on the start page. */
export interface HomeProblem {
  /** Stable while the problem lasts. */
  readonly key: string;
  readonly code: string;
  readonly isError: boolean;
  /** The client or session that the sentence begins with. */
  readonly subject: string | undefined;
  /** The rest of the sentence. */
  readonly text: string;
  /** Recommended action; may be empty. */
  readonly remedy: string;
  readonly link: ProblemLink | undefined;
  readonly action: ProblemAction | undefined;
}

/** Source of the names in the sentences. */
export interface ProblemContext {
  /** Client with its display name. */
  findClient(id: string): Client | undefined;
  /** Name that the client gave itself, which the master uses in its sentences. */
  ownName(id: string): string | undefined;
  readonly sessions: readonly Session[];
}

/** Returns all problems of the master and of sessions, errors first. */
export function homeProblems(
  problems: readonly StatusProblem[],
  context: ProblemContext,
): HomeProblem[] {
  const ofMaster = problems
    // Sessions report their problems in full.
    .filter(({ code }) => code !== 'session_degraded')
    .map((problem) => ofStatus(problem, context));
  const ofSessions = sessionProblems(context.sessions).map(
    ({ session, problem }, index): HomeProblem => ({
      key: `session ${session.id} ${problem.code} ${problem.moduleId} ${index}`,
      code: problem.code,
      isError: true,
      subject: `${session.name}:`,
      text: problem.message,
      remedy: '',
      link: { text: 'Open session', to: sessionLocation(session.id) },
      action: { kind: 'stop-session', sessionId: session.id },
    }),
  );
  return [...ofSessions, ...ofMaster].sort((a, b) => Number(b.isError) - Number(a.isError));
}

/** Codes with several possible problems, which are distinguished by the first clause of their text. */
const IN_TEXT: ReadonlySet<string> = new Set(['limit_reached', 'file_broken']);

function ofStatus(problem: StatusProblem, { findClient, ownName }: ProblemContext): HomeProblem {
  const { code, clientId, sessionId, moduleId, severity, text, remedy } = problem;
  const own = clientId === '' ? undefined : ownName(clientId);
  const parts = problemParts(text, own);
  // In sentences about the master that mention a client, the master comes first.
  const isAboutClient = own !== undefined && own !== '' && text.startsWith(`${own} `);
  return {
    key: `${code} ${clientId} ${sessionId} ${moduleId} ${IN_TEXT.has(code) ? text.split(',', 1)[0] : ''}`,
    code,
    isError: severity === StatusProblemSeverity.ERROR,
    subject: isAboutClient ? (findClient(clientId)?.name ?? parts.subject) : undefined,
    text: isAboutClient ? parts.text : text,
    remedy,
    link: linkOf(problem),
    action: actionOf(problem),
  };
}

function linkOf({ code, clientId, sessionId }: StatusProblem): ProblemLink | undefined {
  if (code === 'limit_reached') return { text: 'Open limits', to: '/settings/limits' };
  if (code === 'cluster_unreachable') return { text: 'Open masters', to: '/settings/masters' };
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
