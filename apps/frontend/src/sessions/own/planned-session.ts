import type { Init, Session } from '@ubii/proto';

/** `tab`: this tab; `master`; the client id of a node; empty: the master chooses. */
export type ModulePlace = string;

/** A session that a page wants to run, and its node. */
export interface SessionPlan {
  /** Module names are unique; `place` determines their nodes. */
  readonly session: Init<Session>;
  readonly place: ModulePlace;
}

/**
 * Returns the session to send to the master.
 *
 * @param known the session on the master; a module with the same name keeps its id, so that it continues
 * @param nodeId node of its modules
 */
export function plannedSession(
  { session }: SessionPlan,
  known: Session | undefined,
  nodeId: string,
): Init<Session> {
  const processingModules = (session.processingModules ?? []).map((module) => {
    const before = known?.processingModules.find(({ name }) => name === module.name);
    return before
      ? {
          ...before,
          nodeId,
          extension: before.extension && { ...before.extension, replaceable: false },
        }
      : { ...module, nodeId };
  });
  return { ...session, ...(known && { id: known.id }), processingModules };
}
