import type { ModuleEvent, Session, SessionProblem } from '@ubii/proto';
import { firstCause } from './event-log.ts';

/** The master names a module whose runs fail. [SE-12] */
export const RUN_FAILED = 'module_run_failed';

/** A problem of a session, with how often it came up. */
export type CountedProblem = SessionProblem & { readonly count?: number | undefined };

/**
 * What goes wrong now in the runs of modules of which the session itself names no other error.
 *
 * @param events oldest first
 * @param nowMs milliseconds since the epoch, of the master's clock
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
