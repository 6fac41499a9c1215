import type { Init, Session } from '@ubii/proto';

/** `tab`: this tab · `master` · the client id of a node. */
export type ModulePlace = string;

/** A session that a page wants to run, and where. */
export interface SessionPlan {
  /** Modules have names that differ; their nodes follow from `place`. */
  readonly session: Init<Session>;
  readonly place: ModulePlace;
}

/**
 * The session to send to the master.
 *
 * @param known what the master has of it; a module with the same name keeps its id, so that it goes on
 * @param nodeId where its modules run
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
