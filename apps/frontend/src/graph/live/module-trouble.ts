import type { ModuleEvent, Session, SessionProblem } from '@ubii/proto';
import { firstCause } from '../../sessions/live/event-log.ts';
import { RUN_FAILED } from '../../sessions/live/run-problems.ts';

/** Problems of a module. */
export interface ModuleTrouble {
  readonly count: number;
  /** First error in the current session status; otherwise the first of the last seconds. */
  readonly failure: Pick<SessionProblem, 'message'> | undefined;
  /** Event of that error, which may have its position in the code. */
  readonly event: ModuleEvent | undefined;
}

/**
 * @param events oldest first
 * @param nowMs current time of the master's clock, epoch milliseconds
 */
export function moduleTrouble(
  session: Pick<Session, 'extension'>,
  events: readonly ModuleEvent[],
  moduleId: string,
  nowMs: number,
): ModuleTrouble {
  const problems = (session.extension?.problems ?? []).filter((one) => one.moduleId === moduleId);
  const [error] = problems.filter(({ isError, code }) => isError && code !== RUN_FAILED);
  // The event has the author's message and its position in the code.
  const run = problems.find(({ code }) => code === RUN_FAILED);
  const recent = error === undefined ? firstCause(events, moduleId, nowMs) : undefined;
  const named = error ?? run;
  const cause = recent ?? (named === undefined ? undefined : firstCause(events, moduleId));
  const count = problems.length + (recent === undefined || run !== undefined ? 0 : 1);
  return { count, failure: error ?? recent?.event ?? cause?.event ?? run, event: cause?.event };
}

export const isSameTrouble = (a: ModuleTrouble, b: ModuleTrouble): boolean =>
  a.count === b.count && a.failure === b.failure && a.event === b.event;
