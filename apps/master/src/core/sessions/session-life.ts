import { ServiceError } from '@ubii/proto';
import { quote } from '../texts/quote.ts';
import type { LifeContext } from './life-context.ts';
import { placeModule } from './place-module.ts';
import { warningProblem } from './problems.ts';
import type { Session } from './session.ts';
import type { SessionModule } from './session-module.ts';
import { canHappen, type SessionEvent } from './session-states.ts';

/** Starts a session: places its modules on nodes, and announces it [SE-11]. @throws ServiceError */
export function startSession(context: LifeContext, session: Session): void {
  if (!canHappen(session.life, 'start')) {
    throw new ServiceError(
      'failed_precondition',
      `The session ${quote(session.label)} is ${session.life}, but only a created or stopped session can be started.`,
    );
  }
  if (session.modules.length === 0) {
    throw new ServiceError(
      'failed_precondition',
      `The session ${quote(session.label)} has no modules to start. Add modules with an update.`,
    );
  }
  for (const module of session.modules) {
    module.clearStatistics();
    placeModule(context, module);
  }
  move(context, session, 'start');
  context.news.announceStart(session);
  context.news.announceChange(session);
  syncLocal(context, session);
  evaluate(context, session);
}

/** Stops a session, if it runs [SE-13]. */
export function stopSession(context: LifeContext, session: Session): void {
  if (!canHappen(session.life, 'stop')) return;
  move(context, session, 'stop');
  for (const module of session.modules) module.end(hasInstance(context, module));
  context.news.announceStop(session);
  context.news.announceChange(session);
  syncLocal(context, session);
  evaluate(context, session);
}

/** True when a node has or creates an instance of the module, so that the session must wait for it. */
function hasInstance({ nodes, local }: LifeContext, module: SessionModule): boolean {
  if (module.nodeId === nodes.masterId) return local.isBusyWith(module.id);
  const isPlaced = module.phase === 'waiting' || module.phase === 'running';
  return isPlaced && nodes.get(module.nodeId)?.isAvailable === true;
}

/** Pauses a session: its modules keep their state [SE-14]. @throws ServiceError */
export function pauseSession(context: LifeContext, session: Session): void {
  requireLife(session, 'pause', 'only a running session can be paused');
  move(context, session, 'pause');
  for (const module of session.modules) {
    const node = context.nodes.get(module.nodeId);
    if (node === undefined || node.extension !== undefined) continue;
    session.troubles.set(
      `pause ${node.id}`,
      warningProblem({
        code: 'node_cannot_pause',
        message: `The node ${quote(node.label)} cannot pause modules. They continue to run while the session is paused.`,
        nodeId: node.id,
      }),
    );
  }
  context.news.announceChange(session);
  syncLocal(context, session);
}

/** Resumes a paused session [SE-14]. @throws ServiceError */
export function resumeSession(context: LifeContext, session: Session): void {
  requireLife(session, 'resume', 'only a paused session can be resumed');
  for (const key of [...session.troubles.keys()]) {
    if (key.startsWith('pause ')) session.troubles.delete(key);
  }
  move(context, session, 'resume');
  evaluate(context, session);
  context.news.announceChange(session);
  syncLocal(context, session);
}

/** Updates the state of a session from the phases of its modules [SE-12] [SE-13]. */
export function evaluate(context: LifeContext, session: Session): void {
  const { modules, life } = session;
  const count = (phase: Session['modules'][number]['phase']): number =>
    modules.filter((module) => module.phase === phase).length;
  if (life === 'stopping') {
    if (count('ending') > 0) return;
    move(context, session, 'all ended');
    context.news.announceChange(session);
    return;
  }
  if (life === 'paused' || !session.isLive) return;
  if (count('running') === modules.length && modules.length > 0) {
    if (!moveAndAnnounce(context, session, 'all run')) return;
    if (session.recordRun()) context.news.announceRunning(session);
    return;
  }
  if (life !== 'starting') {
    // A module that an update starts or restarts also has time to start.
    const isMissing = modules.some(
      (module) => module.phase !== 'running' && !isStartingInTime(context, module),
    );
    if (isMissing) moveAndAnnounce(context, session, 'some run');
    return;
  }
  // Overdue modules count as failed, but may still start.
  const hasFailed = count('failed') === modules.length || isOverdue(context, session);
  const canRunNone = count('running') === 0 && count('away') === 0;
  if (hasFailed && canRunNone && !session.isRestored) stopSession(context, session);
  else if (count('waiting') === 0 || isOverdue(context, session)) {
    moveAndAnnounce(context, session, 'some run');
  }
}

/** The time for nodes to start its modules is over [SE-12]. */
function isOverdue(context: LifeContext, session: Session): boolean {
  return session.modules.every((module) => !isStartingInTime(context, module));
}

/** Its node was asked to start it, and still has time to report [SE-12]. */
function isStartingInTime(
  { clock, limits }: LifeContext,
  { phase, waitingSinceMs }: SessionModule,
): boolean {
  return phase === 'waiting' && clock.monotonicMs() - waitingSinceMs < limits.startTimeoutMs;
}

/** Makes the master's own instances follow the session. */
export function syncLocal({ local, nodes }: LifeContext, session: Session): void {
  const { id, isPaused, revision } = session;
  const modules = session.isLive ? session.modulesOn(nodes.masterId) : [];
  local.sync(
    id,
    modules
      .filter((module) => module.isPlaced)
      .map((module) => ({ spec: module.toSpec(id, isPaused), isPaused, revision })),
  );
}

function requireLife(session: Session, event: SessionEvent, rule: string): void {
  if (canHappen(session.life, event)) return;
  throw new ServiceError(
    'failed_precondition',
    `The session ${quote(session.label)} is ${session.life}, but ${rule}.`,
  );
}

/** Changes the state, and announces the session if that changed something. */
function moveAndAnnounce(context: LifeContext, session: Session, event: SessionEvent): boolean {
  if (!move(context, session, event)) return false;
  context.news.announceChange(session);
  return true;
}

function move({ onLife, clock }: LifeContext, session: Session, event: SessionEvent): boolean {
  if (!session.handle(event, clock.monotonicMs())) return false;
  onLife.emit(session);
  return true;
}
