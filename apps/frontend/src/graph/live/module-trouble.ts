import { ModuleEventKind, type ModuleEvent, type Session, type SessionProblem } from '@ubii/proto';

/** What is wrong with a module. */
export interface ModuleTrouble {
  readonly count: number;
  /** The first error that the session names now, else what went wrong in the last seconds. */
  readonly failure: Pick<SessionProblem, 'message'> | undefined;
  /** The newest event of something that went wrong; it may say where in the code. */
  readonly event: ModuleEvent | undefined;
}

const BAD: ReadonlySet<ModuleEventKind> = new Set([
  ModuleEventKind.ERROR,
  ModuleEventKind.KILLED,
  ModuleEventKind.FAILED,
]);

/** An error of a run counts for so long. */
const RECENT_MS = 10_000;

/**
 * @param events oldest first
 * @param nowMs epoch milliseconds, of the master's clock
 */
export function moduleTrouble(
  session: Pick<Session, 'extension'>,
  events: readonly ModuleEvent[],
  moduleId: string,
  nowMs: number,
): ModuleTrouble {
  const problems = (session.extension?.problems ?? []).filter((one) => one.moduleId === moduleId);
  const event = events.findLast((one) => one.moduleId === moduleId && BAD.has(one.kind));
  const isRecent = event !== undefined && nowMs - event.timeMs < RECENT_MS;
  const error = problems.find(({ isError }) => isError);
  const count = problems.length + (isRecent && error === undefined ? 1 : 0);
  return { count, failure: error ?? (isRecent ? event : undefined), event };
}

export const isSameTrouble = (a: ModuleTrouble, b: ModuleTrouble): boolean =>
  a.count === b.count && a.failure === b.failure && a.event === b.event;
