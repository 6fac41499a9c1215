import type { ModuleEvent, Session, SessionProblem } from '@ubii/proto';
import { firstCause } from '../../sessions/live/event-log.ts';

/** What is wrong with a module. */
export interface ModuleTrouble {
  readonly count: number;
  /** The first error that the session names now, else the first cause of the last seconds. */
  readonly failure: Pick<SessionProblem, 'message'> | undefined;
  /** The event of that cause; it may say where in the code. */
  readonly event: ModuleEvent | undefined;
}

/**
 * @param events oldest first
 * @param nowMs milliseconds since the epoch, of the master's clock
 */
export function moduleTrouble(
  session: Pick<Session, 'extension'>,
  events: readonly ModuleEvent[],
  moduleId: string,
  nowMs: number,
): ModuleTrouble {
  const problems = (session.extension?.problems ?? []).filter((one) => one.moduleId === moduleId);
  const error = problems.find(({ isError }) => isError);
  const recent = error === undefined ? firstCause(events, moduleId, nowMs) : undefined;
  const cause = recent ?? (error === undefined ? undefined : firstCause(events, moduleId));
  const count = problems.length + (recent === undefined ? 0 : 1);
  return { count, failure: error ?? recent?.event, event: cause?.event };
}

export const isSameTrouble = (a: ModuleTrouble, b: ModuleTrouble): boolean =>
  a.count === b.count && a.failure === b.failure && a.event === b.event;
