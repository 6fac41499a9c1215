import type { LifeContext } from './life-context.ts';
import { placeModule } from './place-module.ts';
import type { Session } from './session.ts';
import { evaluate, syncLocal } from './session-life.ts';
import type { SessionModule } from './session-module.ts';

/** A node became unavailable, or left: places its modules on other nodes, or makes them wait [SE-31]. */
export function handleNodeGone(context: LifeContext, nodeId: string): void {
  for (const session of context.sessions()) {
    const affected = session
      .modulesOn(nodeId)
      .filter((module) => module.isPlaced || module.phase === 'ending');
    if (affected.length === 0) continue;
    if (session.life === 'stopping') {
      for (const module of affected) module.end(false);
      evaluate(context, session);
    } else if (session.isLive) {
      placeAgain(context, session, affected);
    }
  }
}

/** A node connected: places modules that wait [SE-31]. */
export function handleNodeBack(context: LifeContext, nodeId: string): void {
  for (const session of context.sessions()) {
    if (!session.isLive) continue;
    const waiting = session.modules.filter(
      ({ phase, requestedNodeId }) =>
        phase === 'away' && (requestedNodeId === nodeId || requestedNodeId === undefined),
    );
    if (waiting.length > 0) placeAgain(context, session, waiting);
  }
}

/** Places modules again, and announces that to their nodes. */
export function placeAgain(
  context: LifeContext,
  session: Session,
  modules: readonly SessionModule[],
): void {
  let isChanged = false;
  for (const module of modules) {
    const before = module.phase;
    placeModule(context, module);
    isChanged ||= module.phase !== before || module.phase !== 'away';
  }
  if (!isChanged) return;
  evaluate(context, session);
  context.news.announceChange(session);
  announceToNodes(context, session, modules);
  syncLocal(context, session);
}

/**
 * Nodes of ours see in a changed session what is theirs now; those of the original start modules only
 * when a session starts, so each gets one that consists of its new modules.
 */
export function announceToNodes(
  { clients, nodes, news }: LifeContext,
  session: Session,
  modules: readonly SessionModule[],
): void {
  const message = session.toMessage();
  const nodeIds = new Set(
    modules.filter(({ phase }) => phase === 'waiting').map(({ nodeId }) => nodeId),
  );
  for (const nodeId of nodeIds) {
    const client = clients.get(nodeId);
    if (client === undefined || nodes.get(nodeId)?.extension !== undefined) continue;
    const ids = new Set(modules.filter((one) => one.nodeId === nodeId).map(({ id }) => id));
    news.sendToNode(client, 'startSession', {
      ...message,
      processingModules: message.processingModules.filter(({ id }) => ids.has(id)),
      ioMappings: message.ioMappings.filter((mapping) => ids.has(mapping.processingModuleId)),
    });
  }
}
