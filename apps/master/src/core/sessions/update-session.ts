import { identityChanges, moduleIdentity, type InstanceSpec } from '@ubii/pm-sandbox';
import { encode, ServiceError } from '@ubii/proto';
import { quote } from '../texts/quote.ts';
import type { SessionDraft } from './draft.ts';
import type { LifeContext } from './life-context.ts';
import { tellNodes } from './node-changes.ts';
import { assignNode, placeModule } from './place-module.ts';
import { warningProblem } from './problems.ts';
import { createModule, type Session } from './session.ts';
import { evaluate, syncLocal } from './session-life.ts';
import type { SessionModule } from './session-module.ts';

/** Replaces the specification of a session, also while it runs [SE-15]. @throws ServiceError */
export function updateSession(context: LifeContext, session: Session, draft: SessionDraft): void {
  const { modules: drafts, ...description } = draft;
  if (session.isLive && drafts.length === 0) {
    throw new ServiceError(
      'failed_precondition',
      `The session ${quote(session.label)} is ${session.life}, and a running session needs at least one module. Stop it first.`,
    );
  }
  const before = session.modules;
  session.description = description;
  session.revision++;
  session.modules = drafts.map((one) => createModule(one));
  const unheard = new Set<string>();
  const started: SessionModule[] = [];
  for (const module of session.modules) {
    const old = before.find(({ id }) => id === module.id);
    if (!session.isLive) {
      assignNode(context, module);
      // Still wait for a node that was told to end the module.
      if (old?.phase === 'ending') module.phase = 'ending';
    } else if (old !== undefined && staysPut(module, old))
      takeOver(context, session, module, old, unheard);
    else {
      if (old !== undefined && old.isPlaced && isForeign(context, old.nodeId))
        unheard.add(old.nodeId);
      placeModule(context, module);
      // The master may place the module on the same node again.
      if (old?.isPlaced === true && old.nodeId === module.nodeId && !isForeign(context, old.nodeId))
        takeOver(context, session, module, old, unheard);
      else started.push(module);
    }
  }
  for (const old of before) {
    const isGone = session.module(old.id) === undefined;
    if (isGone && session.isLive && old.isPlaced && isForeign(context, old.nodeId))
      unheard.add(old.nodeId);
  }
  for (const nodeId of unheard) {
    session.troubles.set(`update ${nodeId}`, cannotUpdate(context, nodeId));
  }
  if (session.isLive || session.life === 'stopping') evaluate(context, session);
  if (!session.isLive) return;
  tellNodes(context, session, started);
  syncLocal(context, session);
}

/** The module stays on its node: the request names no other node. */
function staysPut(module: SessionModule, old: SessionModule): boolean {
  return (
    (old.isPlaced || old.phase === 'away') &&
    module.name === old.name &&
    (module.wishedNodeId === old.wishedNodeId || module.wishedNodeId === old.nodeId)
  );
}

/** The module goes on as it was, with what has changed. */
function takeOver(
  context: LifeContext,
  session: Session,
  module: SessionModule,
  old: SessionModule,
  unheard: Set<string>,
): void {
  const { nodeId, language } = old.spec;
  module.spec = { ...module.spec, nodeId, language };
  module.phase = old.phase;
  module.problem = old.problem;
  module.statistics = old.statistics;
  module.waitingSinceMs = old.waitingSinceMs;
  if (old.phase === 'away') return;
  if (isForeign(context, nodeId)) {
    if (!isEqual(module, old)) unheard.add(nodeId);
    return;
  }
  const isOnMaster = nodeId === context.nodes.masterId;
  const identityOf = (one: SessionModule) =>
    moduleIdentity(asItsNodeSeesIt(one.toSpec(session.id, session.isPaused), isOnMaster));
  const isSame = identityChanges(identityOf(old), identityOf(module)).length === 0;
  if (isSame && module.phase !== 'failed') return;
  // Its node starts it again, and says when it runs.
  module.phase = 'waiting';
  module.problem = undefined;
  module.waitingSinceMs = context.clock.monotonicMs();
}

/** A client knows itself what it trusts, and what a module of its own needs. */
function asItsNodeSeesIt(spec: InstanceSpec, isOnMaster: boolean): InstanceSpec {
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

/** A node of the original hears of a session only when it starts and stops. */
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
