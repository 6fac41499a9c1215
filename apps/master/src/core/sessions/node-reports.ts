import type { ModuleFault } from '@ubii/pm-sandbox';
import {
  ModuleEventKind,
  StatusEventKind,
  type EndedTopics,
  type ModuleEvent,
  type ModuleReports,
} from '@ubii/proto';
import { readNodeMessage, type EncodedNodeMessage } from '@ubii/proto/wire';
import type { Client } from '../clients/client.ts';
import type { EventLog } from '../counters/event-log.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { Hook } from '../hooks/hook.ts';
import { chooseNode } from '../nodes/placement.ts';
import { cutTexts } from '../texts/bound-texts.ts';
import { quote } from '../texts/quote.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import type { LifeContext } from './life-context.ts';
import type { Lockstep } from './lockstep/lockstep.ts';
import { placeAgain } from './node-changes.ts';
import { errorProblem } from './problems.ts';
import type { RunTroubles } from './run-troubles.ts';
import type { Session } from './session.ts';
import { evaluate } from './session-life.ts';
import type { SessionModule } from './session-module.ts';
import type { SessionTable } from './session-table.ts';

/** A node reports that a module runs; a late report counts as well [SE-12]. */
function handleStarted(context: LifeContext, session: Session, module: SessionModule): void {
  if (!session.isLive) {
    sendStop(context, session, module.nodeId);
    return;
  }
  if (module.phase === 'running') return;
  const hadProblem = module.problem !== undefined;
  module.handleRunning();
  const before = session.life;
  evaluate(context, session);
  if (hadProblem && session.life === before) context.news.announceChange(session);
}

/** A node reports that a module has ended: on request, or by itself. */
function handleStopped(context: LifeContext, session: Session, module: SessionModule): void {
  if (module.phase === 'ending') {
    module.end(false);
    evaluate(context, session);
  } else if (session.isLive && module.phase === 'running') {
    if (canMove(context, module)) placeAgain(context, session, [module]);
    else fail(context, session, module, 'its node ended it');
  }
}

/** A module could not be started, or broke [SE-12]. */
function handleFailed(
  context: LifeContext,
  session: Session,
  module: SessionModule,
  reason: string,
  place: Pick<ModuleFault, 'line' | 'column'> | undefined,
): void {
  if (module.phase === 'ending') return handleStopped(context, session, module);
  if (session.isLive && module.isPlaced) fail(context, session, module, reason, place);
}

/** Another node can run the module: its own would only end it again. */
function canMove({ nodes, loadOf }: LifeContext, module: SessionModule): boolean {
  if (module.requestedNodeId !== undefined) return false;
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
  module.handleFailed(
    errorProblem({
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
    }),
  );
  context.log.warn('a module does not run', {
    session: session.label,
    module: module.name,
    node: node?.label ?? module.nodeId,
    reason,
  });
  evaluate(context, session);
  context.news.announceChange(session);
}

/** Sends the stop of a session to a node that still runs its modules [SE-33]. */
function sendStop({ clients, news }: LifeContext, session: Session, nodeId: string): void {
  const client = clients.get(nodeId);
  if (client !== undefined) news.sendToNode(client, 'stopSession', session.toMessage());
}

/** Dependencies for handling the reports of nodes. */
export interface NodeReportsContext {
  readonly life: LifeContext;
  readonly limitWatch: LimitWatch;
  readonly events: EventLog;
  readonly table: SessionTable;
  readonly lockstep: Lockstep;
  readonly topics: TopicTable;
  readonly runTroubles: RunTroubles;
}

/** Handles messages of nodes: replies to lockstep passes, and reports on modules [EX-20]. The master is one of the nodes. */
export class NodeReports {
  readonly #context: NodeReportsContext;
  /** Called with the bytes of each message, before it is read. */
  readonly onBytes = new Hook<[client: Client, bytes: Uint8Array]>();
  /** Called with each message, for parts that handle other members. */
  readonly onMessage = new Hook<[client: Client, message: EncodedNodeMessage]>();

  constructor(context: NodeReportsContext) {
    this.#context = context;
  }

  /** @throws DecodeError when the bytes are no message of a node */
  handleMessage(client: Client, bytes: Uint8Array): void {
    this.onBytes.emit(client, bytes);
    const message = readNodeMessage(bytes);
    const { lockstepReply, moduleReports, endedTopics } = message;
    if (lockstepReply !== undefined) {
      const { sessionId, pass } = lockstepReply.head;
      // The frame may be reused before all nodes have replied.
      const records = lockstepReply.records.map((record) => record.slice());
      this.#context.lockstep.handleReply(client.id, sessionId, pass, records);
    }
    if (moduleReports !== undefined) this.#takeReports(client, moduleReports);
    if (endedTopics !== undefined) this.#endTopics(client, endedTopics);
    this.onMessage.emit(client, message);
  }

  /** A module runs, or has ended. Returns false when no session has it on this node [SE-32]. */
  handleRuntime(nodeId: string, moduleId: string, isRunning: boolean): boolean {
    const { table, life } = this.#context;
    const found = table.findModule(moduleId);
    if (found?.module.nodeId !== nodeId) return false;
    if (isRunning) handleStarted(life, found.session, found.module);
    else handleStopped(life, found.session, found.module);
    return true;
  }

  /** A module could not be created, or failed later [SE-12]. */
  handleFailed(
    nodeId: string,
    moduleId: string,
    reason: string,
    fault: Pick<ModuleFault, 'line' | 'column' | 'shortage'> | undefined,
  ): void {
    const { table, life } = this.#context;
    const found = table.findModule(moduleId);
    if (found === undefined) return;
    const { session, module } = found;
    if (fault?.shortage !== undefined) this.#noteShortage(session, module, fault.shortage);
    if (module.nodeId === nodeId) handleFailed(life, session, module, reason, fault);
  }

  /** An event of a module on any node [SE-51]. */
  handleEvent(nodeId: string, event: ModuleEvent): void {
    const { table, life, runTroubles } = this.#context;
    const found = table.findModule(event.moduleId);
    // Ignore reports about modules of other nodes.
    if (found === undefined || found.module.nodeId !== nodeId) return;
    const { session, module } = found;
    const report = {
      ...cutTexts('ubii.extension.ModuleEvent', event, life.limits),
      sessionId: session.id,
      moduleName: module.name,
      nodeId,
    };
    life.news.publishEvent(report);
    runTroubles.handleEvent(session, module, report);
  }

  /** A module on the master did not get memory [SE-65]. */
  #noteShortage(session: Session, module: SessionModule, shortage: 'all' | 'owner'): void {
    const { life, limitWatch, events } = this.#context;
    const { masterId } = life.nodes;
    limitWatch.count(shortage === 'all' ? 'moduleBytes' : 'moduleBytesPerSession', masterId);
    const whose = shortage === 'all' ? 'all modules on the master' : 'the modules of its session';
    events.add(
      StatusEventKind.LIMIT_REACHED,
      `The module ${quote(module.name)} of the session ${quote(session.label)} was ended: the memory for ${whose} is used up`,
      masterId,
    );
  }

  /** [SE-63] */
  #endTopics(client: Client, { topics }: EndedTopics): void {
    const { topics: table, life } = this.#context;
    for (const topic of topics) {
      if (!client.recordBudget.take(1, life.clock.monotonicMs())) return;
      const entry = table.get(topic);
      // A node cannot delete values of other publishers.
      if (entry?.owner === client) table.deleteValue(entry);
    }
  }

  /** [PM-80] [PM-81] */
  #takeReports(client: Client, { statistics, events }: ModuleReports): void {
    const { table, life } = this.#context;
    const { limits, clock } = life;
    for (const one of statistics) {
      const module = table.findModule(one.moduleId)?.module;
      if (module?.nodeId === client.id) {
        const bounded = cutTexts('ubii.extension.ModuleStatistics', one, limits);
        module.recordStatistics(
          { ...bounded, nodeId: client.id, moduleName: module.name },
          clock.monotonicMs(),
        );
      }
    }
    for (const report of events) {
      // Reports of a node count against its record budget like published records.
      if (!client.recordBudget.take(1, clock.monotonicMs())) return;
      const event = cutTexts('ubii.extension.ModuleEvent', report, limits);
      this.handleEvent(client.id, event);
      if (event.kind === ModuleEventKind.FAILED) {
        this.handleFailed(client.id, event.moduleId, event.message, event);
      }
    }
  }
}
