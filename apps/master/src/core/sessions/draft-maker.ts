import { ServiceError, type Session as SessionMessage, type SessionProblem } from '@ubii/proto';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { quote } from '../texts/quote.ts';
import { checkSession } from './checks/check-session.ts';
import { checkSources, type SourceCheckContext } from './checks/check-sources.ts';
import type { CheckContext } from './checks/check-context.ts';
import { completeModules, type CompletionContext } from './complete-modules.ts';
import { isSourceLongerThan } from './checks/check-modules.ts';
import { describeSession, type DraftModule, type SessionDraft } from './draft.ts';
import { sortProblems } from './problems.ts';
import type { Session } from './session.ts';

/** Dependencies for creating drafts from requests. */
export interface DraftContext {
  readonly limits: LimitWatch;
  readonly completion: CompletionContext;
  readonly checks: CheckContext;
  readonly sources: SourceCheckContext;
}

/**
 * Makes a complete specification of what a request says, and looks at all of it [SE-1] [SE-3].
 * @param before The session that is to be replaced by it, if any: its ids are not taken.
 * @throws ServiceError with every problem when there is an error among them.
 */
export async function makeDraft(
  context: DraftContext,
  message: SessionMessage,
  before?: Session,
): Promise<{ draft: SessionDraft; warnings: SessionProblem[] }> {
  requireSize(context.limits, message);
  const { draft, problems: stray } = completeDraft(context, message, before);
  requireShortSources(context.limits, draft.modules);
  const problems = sortProblems([
    ...stray,
    ...checkSession(draft.modules, context.checks),
    ...(await checkSources(draft.modules, context.sources)),
  ]);
  const errors = problems.filter(({ isError }) => isError);
  if (errors.length > 0) throw invalidSession(message, problems, errors.length);
  return { draft, warnings: problems };
}

/** The complete specification, unchecked. */
export function completeDraft(
  { completion }: DraftContext,
  message: SessionMessage,
  before?: Session,
): { draft: SessionDraft; problems: SessionProblem[] } {
  const { modules, problems } = completeModules(message, {
    ...completion,
    isTaken: (id) => completion.isTaken(id) && before?.module(id) === undefined,
    placed: (id) => before?.module(id),
  });
  return { draft: { ...describeSession(message), modules }, problems };
}

/** The draft of a session that is there, to look at it again. */
export function draftOf(session: Session): SessionDraft {
  return {
    ...session.description,
    modules: session.modules.map((module, index) => ({
      spec: module.spec,
      mapping: module.mapping,
      wishedNodeId: module.wishedNodeId,
      path: `processingModules[${index}]`,
      mappingPath: `ioMappings[${index}]`,
      isLibraryCode: module.isTrusted,
    })),
  };
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
