import type { ModuleEvent, Session, SessionProblem } from '@ubii/proto';
import { firstCause } from './event-log.ts';

/** Code of the master's problem for modules whose runs fail. [SE-12] */
export const RUN_FAILED = 'module_run_failed';

/** A problem of a session, with its number of occurrences. */
export type CountedProblem = SessionProblem & { readonly count?: number | undefined };

/**
 * Returns current errors of runs, for modules without another error in the session status.
 *
 * @param events oldest first
 * @param nowMs epoch milliseconds, master's clock
 */
export function runProblems(
  { extension, processingModules }: Pick<Session, 'extension' | 'processingModules'>,
  events: readonly ModuleEvent[],
  nowMs: number,
): CountedProblem[] {
  const failed = new Set(
    (extension?.problems ?? [])
      .filter(({ isError, code }) => isError && code !== RUN_FAILED)
      .map(({ moduleId }) => moduleId),
  );
  return processingModules.flatMap(({ id, name }) => {
    const cause = failed.has(id) ? undefined : firstCause(events, id, nowMs);
    if (cause === undefined) return [];
    const { message, nodeId, line, column } = cause.event;
    const place = { path: '', moduleId: id, moduleName: name, nodeId, line, column };
    return [{ isError: true, code: 'module_run', message, ...place, count: cause.count }];
  });
}
