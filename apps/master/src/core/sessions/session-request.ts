import { ServiceError, type Session as SessionMessage, type SessionProblem } from '@ubii/proto';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { quote } from '../texts/quote.ts';
import type { CheckContext } from './checks/check-context.ts';
import { isSourceLongerThan } from './checks/check-modules.ts';
import { checkSession, checkSurroundings, SURROUNDINGS } from './checks/check-session.ts';
import { checkSources, type SourceCheckContext } from './checks/check-sources.ts';
import { completeModules, type CompletionContext, type DraftModule } from './complete-modules.ts';
import { sortProblems } from './problems.ts';
import type { Session } from './session.ts';

/** Dependencies for requests that specify a session. */
export interface RequestContext {
  readonly limits: LimitWatch;
  readonly completion: CompletionContext;
  readonly checks: CheckContext;
  readonly sources: SourceCheckContext;
}

/**
 * Completes the modules of a request, and checks them [SE-1] [SE-3].
 *
 * @param before the session to be replaced: its modules keep their ids
 * @throws ServiceError with every problem when there is an error among them
 */
export async function checkRequest(
  context: RequestContext,
  message: SessionMessage,
  before?: Session,
): Promise<{ modules: readonly DraftModule[]; warnings: SessionProblem[] }> {
  requireSize(context.limits, message);
  const { modules, problems: stray } = completeRequest(context, message, before);
  requireShortSources(context.limits, modules);
  const problems = sortProblems([
    ...stray,
    ...checkSession(modules, context.checks),
    ...(await checkSources(modules, context.sources)),
  ]);
  const errors = problems.filter(({ isError }) => isError);
  if (errors.length > 0) throw invalidSession(message, problems, errors.length);
  return { modules, warnings: inOrderOfModules(context, modules, problems) };
}

/** Completes the modules of a request, unchecked. */
export function completeRequest(
  { completion }: RequestContext,
  message: SessionMessage,
  before?: Session,
): { modules: readonly DraftModule[]; problems: SessionProblem[] } {
  return completeModules(message, {
    ...completion,
    isTaken: (id) => completion.isTaken(id) && before?.module(id) === undefined,
    placed: (id) => before?.module(id),
  });
}

/** Returns the warnings of a session after another check of its surroundings [SE-5]. */
export function recheckWarnings({ checks }: RequestContext, session: Session): SessionProblem[] {
  const modules = session.modules.map((module, index) => ({
    spec: module.spec,
    mapping: module.mapping,
    requestedNodeId: module.requestedNodeId,
    path: `processingModules[${index}]`,
    mappingPath: `ioMappings[${index}]`,
    isLibraryCode: module.isTrusted,
  }));
  const context: CheckContext = { ...checks };
  // The modules of a live session report problems of their nodes.
  if (session.isLive) context.nodeProblem = () => undefined;
  return [
    ...session.warnings.filter(({ code }) => !SURROUNDINGS.has(code)),
    ...checkSurroundings(modules, context),
  ];
}

/** Mappings of a session stand in the order of its modules, which those of a request need not. */
function inOrderOfModules(
  { checks }: RequestContext,
  drafts: readonly DraftModule[],
  found: SessionProblem[],
): SessionProblem[] {
  const isInOrder = drafts.every(
    ({ mappingPath }, index) => mappingPath === `ioMappings[${index}]`,
  );
  if (isInOrder) return found;
  const modules = drafts.map((module, index) => ({
    ...module,
    mappingPath: `ioMappings[${index}]`,
  }));
  const others = found.filter(({ code }) => code === 'not_checked');
  return [...checkSession(modules, checks), ...others];
}

/** [PM-57] */
function requireShortSources(limitWatch: LimitWatch, modules: readonly DraftModule[]): void {
  const { moduleSourceBytes } = limitWatch.limits;
  for (const draft of modules) {
    if (!isSourceLongerThan(draft, moduleSourceBytes)) continue;
    const text = `more than ${moduleSourceBytes} bytes of source in the module ${quote(draft.spec.name)}`;
    throw limitWatch.refusal('moduleSourceBytes', text);
  }
}

/** [SE-7] */
function requireSize(limitWatch: LimitWatch, message: SessionMessage): void {
  const { limits } = limitWatch;
  const { processingModules, ioMappings } = message;
  if (processingModules.length > limits.modulesPerSession) {
    const text = `more than ${limits.modulesPerSession} modules of one session`;
    throw limitWatch.refusal('modulesPerSession', text);
  }
  const mappings = ioMappings.reduce(
    (sum, { inputMappings, outputMappings }) => sum + inputMappings.length + outputMappings.length,
    ioMappings.length,
  );
  if (mappings > limits.mappingsPerSession) {
    const text = `more than ${limits.mappingsPerSession} mappings of one session`;
    throw limitWatch.refusal('mappingsPerSession', text);
  }
}

function invalidSession(
  { name }: SessionMessage,
  problems: readonly SessionProblem[],
  errorCount: number,
): ServiceError {
  const first = problems[0]!;
  const more = errorCount > 1 ? ` (and ${errorCount - 1} more)` : '';
  return new ServiceError(
    'invalid_argument',
    `The session ${name === '' ? '' : `${quote(name)} `}cannot be used: ${first.message}${more}`,
    { details: { problems } },
  );
}
