import { identityChanges, moduleIdentity, type InstanceSpec } from '@ubii/pm-sandbox';
import { encode, ServiceError } from '@ubii/proto';
import { quote } from '../texts/quote.ts';
import type { LifeContext } from './life-context.ts';
import { announceToNodes } from './node-changes.ts';
import { assignNode, placeModule } from './place-module.ts';
import { warningProblem } from './problems.ts';
import type { Session, SessionContent } from './session.ts';
import { evaluate, syncLocal } from './session-life.ts';
import type { SessionModule } from './session-module.ts';

/**
 * Replaces the specification of a session, also while it runs [SE-15].
 *
 * @param isBeingStored as for `Session.replace`
 * @throws ServiceError
 */
export function updateSession(
  context: LifeContext,
  session: Session,
  content: SessionContent,
  isBeingStored: boolean,
): void {
  if (session.isLive && content.modules.length === 0) {
    throw new ServiceError(
      'failed_precondition',
      `The session ${quote(session.label)} is ${session.life}, and a running session needs at least one module. Stop it first.`,
    );
  }
  const before = session.replace(content, isBeingStored);
  const unaware = new Set<string>();
  const started: SessionModule[] = [];
  for (const module of session.modules) {
    const old = before.find(({ id }) => id === module.id);
    if (!session.isLive) {
      assignNode(context, module);
      // Still wait for a node that was asked to end the module.
      if (old?.phase === 'ending') module.end(true);
    } else if (old !== undefined && staysOnNode(module, old))
      continueModule(context, session, module, old, unaware);
    else {
      if (old !== undefined && old.isPlaced && isForeign(context, old.nodeId))
        unaware.add(old.nodeId);
      placeModule(context, module);
      // The master may place the module on the same node again.
      if (old?.isPlaced === true && old.nodeId === module.nodeId && !isForeign(context, old.nodeId))
        continueModule(context, session, module, old, unaware);
      else started.push(module);
    }
  }
  for (const old of before) {
    const isGone = session.module(old.id) === undefined;
    if (isGone && session.isLive && old.isPlaced && isForeign(context, old.nodeId))
      unaware.add(old.nodeId);
  }
  for (const nodeId of unaware) {
    session.troubles.set(`update ${nodeId}`, cannotUpdate(context, nodeId));
  }
  if (session.isLive || session.life === 'stopping') evaluate(context, session);
  if (!session.isLive) return;
  announceToNodes(context, session, started);
  syncLocal(context, session);
}

/** The module stays on its node: the request names no other node. */
function staysOnNode(module: SessionModule, old: SessionModule): boolean {
  return (
    (old.isPlaced || old.phase === 'away') &&
    module.name === old.name &&
    (module.requestedNodeId === old.requestedNodeId || module.requestedNodeId === old.nodeId)
  );
}

/** The module continues on its node, with the changes. */
function continueModule(
  context: LifeContext,
  session: Session,
  module: SessionModule,
  old: SessionModule,
  unaware: Set<string>,
): void {
  const { nodeId } = old;
  module.continueFrom(old);
  if (old.phase === 'away') return;
  if (isForeign(context, nodeId)) {
    if (!isEqual(module, old)) unaware.add(nodeId);
    return;
  }
  const isOnMaster = nodeId === context.nodes.masterId;
  const identityOf = (one: SessionModule) =>
    moduleIdentity(asSeenByNode(one.toSpec(session.id, session.isPaused), isOnMaster));
  const isSame = identityChanges(identityOf(old), identityOf(module)).length === 0;
  if (isSame && module.phase !== 'failed') return;
  module.restart(context.clock.monotonicMs());
}

/** A client knows itself what it trusts, and what a module of its own needs. */
function asSeenByNode(spec: InstanceSpec, isOnMaster: boolean): InstanceSpec {
  if (isOnMaster) return spec;
  const isItsOwn = spec.module.onProcessingStringified === '';
  const module = isItsOwn ? { ...spec.module, extension: undefined } : spec.module;
  return { ...spec, module, isTrusted: false };
}

function isEqual(module: SessionModule, old: SessionModule): boolean {
  const bytes = ({ spec, mapping }: SessionModule): string =>
    JSON.stringify([
      [...encode('ubii.processing.ProcessingModule', spec)],
      [...encode('ubii.sessions.IOMapping', mapping)],
    ]);
  return bytes(module) === bytes(old);
}

/** A node of the original reads sessions only when they start and stop. */
function isForeign({ nodes }: LifeContext, nodeId: string): boolean {
  const node = nodes.get(nodeId);
  return node !== undefined && node.extension === undefined;
}

function cannotUpdate({ nodes }: LifeContext, nodeId: string): ReturnType<typeof warningProblem> {
  return warningProblem({
    code: 'node_cannot_update',
    message: `The node ${quote(nodes.get(nodeId)?.label ?? nodeId)} cannot apply changes while a session runs. They apply there after a stop and a start.`,
    nodeId,
  });
}
