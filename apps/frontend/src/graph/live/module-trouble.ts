import { ModuleEventKind, type ModuleEvent, type Session, type SessionProblem } from '@ubii/proto';

/** What is wrong with a module. */
export interface ModuleTrouble {
  readonly count: number;
  /** The first error that the session names now. */
  readonly failure: Pick<SessionProblem, 'message'> | undefined;
  /** The newest event that says where in the code it happened. */
  readonly event: ModuleEvent | undefined;
}

/** Said by a row without a wire, too. */
const SAID_ANYWAY: ReadonlySet<string> = new Set(['output_not_mapped']);

const BAD: ReadonlySet<ModuleEventKind> = new Set([
  ModuleEventKind.ERROR,
  ModuleEventKind.KILLED,
  ModuleEventKind.FAILED,
]);

/** @param events oldest first */
export function moduleTrouble(
  session: Pick<Session, 'extension'>,
  events: readonly ModuleEvent[],
  moduleId: string,
): ModuleTrouble {
  const problems = (session.extension?.problems ?? []).filter(
    (one) => one.moduleId === moduleId && !SAID_ANYWAY.has(one.code),
  );
  return {
    count: problems.length,
    failure: problems.find(({ isError }) => isError),
    event: events.findLast((one) => one.moduleId === moduleId && BAD.has(one.kind)),
  };
}
