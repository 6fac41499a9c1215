import { ServiceError } from '@ubii/proto';
import { quote } from '../texts/quote.ts';
import type { LifeContext } from './life-context.ts';
import { placeModule } from './place-module.ts';
import { warningProblem } from './problems.ts';
import type { Session } from './session.ts';
import type { SessionModule } from './session-module.ts';
import { canHappen, nextLife, type SessionEvent } from './session-states.ts';

/** Starts a session: its modules are given to nodes, which are told [SE-11]. @throws ServiceError */
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
  session.troubles.clear();
  session.wasRunning = false;
  session.stoppingSinceMs = undefined;
  for (const module of session.modules) {
    module.statistics = undefined;
    placeModule(context, module);
  }
  move(context, session, 'start');
  context.news.announceStart(session);
  context.news.announceChange(session);
  syncLocal(context, session);
  evaluate(context, session);
}

/** Stops a session; of one that does not run nothing is left to do [SE-13]. */
export function stopSession(context: LifeContext, session: Session): void {
  if (!canHappen(session.life, 'stop')) return;
  move(context, session, 'stop');
  session.isRestored = false;
  session.stoppingSinceMs = context.clock.monotonicMs();
  session.troubles.clear();
  for (const module of session.modules) {
    // The session does not wait for the node any more.
    if (module.phase === 'away') module.problem = undefined;
    module.phase = isThere(context, module) ? 'ending' : 'idle';
  }
  context.news.announceStop(session);
  context.news.announceChange(session);
  syncLocal(context, session);
  evaluate(context, session);
}

/** True when a node has or creates an instance of the module, so that the session must wait for it. */
function isThere({ nodes, local }: LifeContext, module: SessionModule): boolean {
  if (module.nodeId === nodes.masterId) return local.isBusyWith(module.id);
  const isGiven = module.phase === 'waiting' || module.phase === 'running';
  return isGiven && nodes.get(module.nodeId)?.isAvailable === true;
}

/** Holds a session: its modules keep their state [SE-14]. @throws ServiceError */
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

/** Lets a session that is held run on [SE-14]. @throws ServiceError */
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

/** Draws the conclusions from how its modules are [SE-12] [SE-13]. */
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
    if (!moveAndTell(context, session, 'all run') || session.wasRunning) return;
    session.wasRunning = true;
    context.news.announceRunning(session);
    return;
  }
  if (life !== 'starting') {
    // A module that an update starts or restarts has its time, too: until then nothing is wrong.
    const isMissing = modules.some(
      (module) => module.phase !== 'running' && !isStartingInTime(context, module),
    );
    if (isMissing) moveAndTell(context, session, 'some run');
    return;
  }
  // Overdue modules count as failed, but may still start.
  const isHopeless = count('failed') === modules.length || isOverdue(context, session);
  const isNothingThere = count('running') === 0 && count('away') === 0;
  if (isHopeless && isNothingThere && !session.isRestored) stopSession(context, session);
  else if (count('waiting') === 0 || isOverdue(context, session)) {
    moveAndTell(context, session, 'some run');
  }
}

/** Nodes had their time to start its modules [SE-12]. */
function isOverdue(context: LifeContext, session: Session): boolean {
  return session.modules.every((module) => !isStartingInTime(context, module));
}

/** Its node was told to start it, and still has time to report [SE-12]. */
function isStartingInTime(
  { clock, limits }: LifeContext,
  { phase, waitingSinceMs }: SessionModule,
): boolean {
  return phase === 'waiting' && clock.monotonicMs() - waitingSinceMs < limits.startTimeoutMs;
}

/** The master's own modules of this session become what the session says. */
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

/** Moves it on, and tells everybody if that changed something. */
function moveAndTell(context: LifeContext, session: Session, event: SessionEvent): boolean {
  if (!move(context, session, event)) return false;
  context.news.announceChange(session);
  return true;
}

function move({ onLife, clock }: LifeContext, session: Session, event: SessionEvent): boolean {
  const life = nextLife(session.life, event);
  if (life === session.life) return false;
  session.life = life;
  session.lifeSinceMs = clock.monotonicMs();
  onLife.emit(session);
  return true;
}
