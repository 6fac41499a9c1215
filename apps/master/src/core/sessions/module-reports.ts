import type { ModuleFault } from '@ubii/pm-sandbox';
import { chooseNode } from '../nodes/placement.ts';
import { quote } from '../texts/quote.ts';
import type { LifeContext } from './life-context.ts';
import { errorProblem } from './problems.ts';
import type { Session } from './session.ts';
import { placeAgain } from './node-changes.ts';
import { evaluate } from './session-life.ts';
import type { SessionModule } from './session-module.ts';

/** A node says that a module runs; late words count as well [SE-12]. */
export function handleStarted(context: LifeContext, session: Session, module: SessionModule): void {
  if (!session.isLive) {
    tellToStop(context, session, module.nodeId);
    return;
  }
  if (module.phase === 'running') return;
  const hadProblem = module.problem !== undefined;
  module.phase = 'running';
  module.problem = undefined;
  const before = session.life;
  evaluate(context, session);
  if (hadProblem && session.life === before) context.news.announceChange(session);
}

/** A node says that a module has ended: as it was told, or by itself. */
export function handleStopped(context: LifeContext, session: Session, module: SessionModule): void {
  if (module.phase === 'ending') {
    module.phase = 'idle';
    evaluate(context, session);
  } else if (session.isLive && module.phase === 'running') {
    if (canMove(context, module)) placeAgain(context, session, [module]);
    else fail(context, session, module, 'its node ended it');
  }
}

/** A module could not be started, or broke [SE-12]. */
export function handleFailed(
  context: LifeContext,
  session: Session,
  module: SessionModule,
  reason: string,
  place: Pick<ModuleFault, 'line' | 'column'> | undefined,
): void {
  if (module.phase === 'ending') return handleStopped(context, session, module);
  if (session.isLive && module.isPlaced) fail(context, session, module, reason, place);
}

/** Another node can have it: its own would only end it again. */
function canMove({ nodes, loadOf }: LifeContext, module: SessionModule): boolean {
  if (module.wishedNodeId !== '') return false;
  const node = chooseNode(module.spec, nodes.list(), loadOf);
  return node !== undefined && node.id !== module.nodeId;
}

function fail(
  context: LifeContext,
  session: Session,
  module: SessionModule,
  reason: string,
  place?: Pick<ModuleFault, 'line' | 'column'>,
): void {
  const node = context.nodes.get(module.nodeId);
  const where = node === undefined ? '' : ` on ${quote(node.label)}`;
  module.phase = 'failed';
  module.problem = errorProblem({
    code: 'module_failed',
    message: `The module ${quote(module.name)}${where} does not run: ${reason}`.replace(
      /\.?$/,
      '.',
    ),
    moduleId: module.id,
    moduleName: module.name,
    nodeId: module.nodeId,
    line: place?.line ?? 0,
    column: place?.column ?? 0,
  });
  context.log.warn('a module does not run', {
    session: session.label,
    module: module.name,
    node: node?.label ?? module.nodeId,
    reason,
  });
  evaluate(context, session);
  context.news.announceChange(session);
}

/** A node runs modules of a session that was stopped meanwhile [SE-33]. */
function tellToStop({ clients, news }: LifeContext, session: Session, nodeId: string): void {
  const client = clients.get(nodeId);
  if (client !== undefined) news.tellNode(client, 'stopSession', session.toMessage());
}
