import type { NodeInfo, Session } from '@ubii/proto';

/** A module of a session that runs on a node. */
export interface HostedModule {
  readonly moduleId: string;
  readonly name: string;
  readonly sessionId: string;
  readonly session: string;
}

/** Load of a node: number of modules, its preferred maximum, and the ratio. */
export interface HostLoad {
  readonly text: string;
  /** 0 to 1; undefined when the node states no maximum. */
  readonly share: number | undefined;
}

/** Modules that run or are assigned on a node, from all sessions. */
export function hostedModules(
  { clientId }: Pick<NodeInfo, 'clientId'>,
  sessions: readonly Session[],
): HostedModule[] {
  return sessions.flatMap(({ id: sessionId, name: session, processingModules }) =>
    processingModules
      .filter(({ nodeId }) => nodeId === clientId)
      .map(({ id: moduleId, name }) => ({ moduleId, name, sessionId, session })),
  );
}

export function hostLoad({ available, instances, node }: NodeInfo): HostLoad {
  if (!available) return { text: 'away', share: undefined };
  const capacity = node?.capacity ?? 0;
  if (capacity > 0)
    return { text: `${instances} of ${capacity}`, share: Math.min(1, instances / capacity) };
  return { text: instances === 0 ? 'idle' : String(instances), share: undefined };
}
