import { StatusEventKind } from '@ubii/proto';
import { readRecordHead } from '@ubii/proto/wire';
import { Hook } from '../hooks/hook.ts';
import { createChecks } from '../sessions/checks/create-checks.ts';
import type { LifeContext } from '../sessions/life-context.ts';
import { Lockstep } from '../sessions/lockstep/lockstep.ts';
import { handleNodeBack, handleNodeGone } from '../sessions/node-changes.ts';
import { NodeReports } from '../sessions/node-reports.ts';
import { ModuleReload } from '../sessions/reload-modules.ts';
import { RunTroubles } from '../sessions/run-troubles.ts';
import { ForeignSessions } from '../sessions/foreign-sessions.ts';
import { SessionClaims } from '../sessions/session-claims.ts';
import { MASTER_ALIAS } from '../sessions/session-library.ts';
import { SessionNews } from '../sessions/session-news.ts';
import type { RequestContext } from '../sessions/session-request.ts';
import { Sessions } from '../sessions/sessions.ts';
import { Supervision } from '../sessions/supervision.ts';
import { TopicTroubles } from '../sessions/topic-troubles.ts';
import { quote } from '../texts/quote.ts';
import type { ClientArea } from './clients.ts';
import type { Foundation } from './foundation.ts';
import type { LibraryArea } from './library.ts';
import type { NodeArea } from './nodes.ts';
import type { MasterPorts } from './settings.ts';
import type { TopicArea } from './topics.ts';

/** Sessions, and the reports of nodes on their modules. */
export type SessionArea = ReturnType<typeof createSessions>;

export type SessionAreaContext = Pick<
  MasterPorts,
  'clock' | 'ids' | 'log' | 'patterns' | 'sandboxes' | 'cluster'
> &
  Pick<Foundation, 'limits' | 'limitWatch' | 'events' | 'onClose'> &
  Pick<TopicArea, 'topics' | 'subscriptions' | 'publisher'> &
  Pick<ClientArea, 'clients' | 'devices'> &
  Pick<LibraryArea, 'modules' | 'history' | 'sessionLibrary'> &
  NodeArea & {
    /** Tells whether an id is that of another master of the cluster. */
    readonly isOtherMaster: (id: string) => boolean;
  };

/** Parts of this area that listen to each other. */
interface Listeners {
  readonly life: LifeContext;
  readonly lockstep: Lockstep;
  readonly reports: NodeReports;
  readonly sessions: Sessions;
  readonly supervision: Supervision;
}

export function createSessions(context: SessionAreaContext) {
  const { clock, limitWatch: limits, modules, sessionLibrary, sessionTable } = context;
  const news = new SessionNews(context);
  const life = createLife(context, news);
  const lockstep = createLockstep(context, news);
  const monotonicMs = (): number => clock.monotonicMs();
  const onChange = news.announceChange.bind(news);
  const runTroubles = new RunTroubles({ monotonicMs, onChange });
  const topicTroubles = new TopicTroubles({
    monotonicMs,
    onRunaway(_session, { nodeId }, text) {
      limits.count('topicsPerModule', nodeId);
      context.events.add(StatusEventKind.LIMIT_REACHED, text, nodeId);
    },
    onChange,
  });
  const reports = new NodeReports({
    ...context,
    life,
    table: sessionTable,
    lockstep,
    runTroubles,
  });
  const claims = new SessionClaims({
    masterId: context.nodes.masterId,
    owners: context.cluster?.owners,
    log: context.log,
  });
  const sessions = new Sessions({
    ...context,
    limits,
    table: sessionTable,
    requests: requestContext(context),
    life,
    claims,
    library: sessionLibrary,
    topics: context.localTopics,
  });
  const supervision = new Supervision({
    ...life,
    passes: (session) => lockstep.statistics(session),
    recheck: (session) => sessions.recheck(session),
    lookAtTroubles(session) {
      topicTroubles.look(session);
      runTroubles.look(session);
    },
  });
  const reload = new ModuleReload({ library: modules, sessions, news });
  listen(context, { life, lockstep, reports, sessions, supervision });
  context.onClose.add(() => {
    for (const part of [news, reload, supervision, lockstep]) part.close();
  });
  return {
    sessions,
    reports,
    reload,
    sessionNews: news,
    claims,
    /** Sessions that other masters run. */
    foreignSessions: new ForeignSessions(),
  };
}

function createLife(context: SessionAreaContext, news: SessionNews): LifeContext {
  const { clock, limits, log, clients, nodes, localNode, sessionTable } = context;
  return {
    clock,
    limits,
    log,
    clients,
    nodes,
    local: localNode,
    news,
    sessions: () => sessionTable.values(),
    loadOf: (node) => sessionTable.loadOf(node.id),
    onLife: new Hook(),
    onModules: new Hook(),
  };
}

function createLockstep(context: SessionAreaContext, news: SessionNews): Lockstep {
  const { localNode: local, localTopics } = context;
  return new Lockstep({
    ...context,
    local,
    news,
    topics: localTopics,
    publish(record, client, sessionId) {
      const { topic, valueField } = readRecordHead(record);
      localTopics.publishAs(client, topic, record, valueField, sessionId);
    },
  });
}

function requestContext(context: SessionAreaContext): RequestContext {
  const { ids, limits, limitWatch, sessionTable, nodes, modules, sandboxes, clock } = context;
  return {
    limits: limitWatch,
    completion: {
      uuid: () => ids.uuid(),
      isTaken: (id) => sessionTable.findModule(id) !== undefined,
      // A session runs at one master, whichever a page names. [CU-76]
      nodeId: (text) =>
        text === MASTER_ALIAS || context.isOtherMaster(text) ? nodes.masterId : text || undefined,
      stored: (name) => modules.get(name),
      offered: (name, nodeId) => nodes.offered(name, nodeId),
    },
    checks: createChecks(context),
    sources: { sandboxes, clock, timeoutMs: limits.sourceCheckTimeoutMs },
  };
}

/** Listeners are called in this order. */
function listen(
  { events, clients, nodes, localNode, sessionTable, sessionLibrary }: SessionAreaContext,
  { life, lockstep, reports, sessions, supervision }: Listeners,
): void {
  life.onLife.add((session) => supervision.handleLife(session));
  life.onLife.add(() => sessions.restored.handleLife());
  life.onLife.add((session) => life.onModules.emit(session));
  life.onLife.add((session) => {
    if (session.life !== 'degraded') return;
    const text = `The session ${quote(session.label)} runs without some of its modules`;
    events.add(StatusEventKind.SESSION_DEGRADED, text);
  });
  life.onModules.add((session) => lockstep.handleLife(session));
  life.onModules.add((session) => {
    const { isLive, description } = session;
    if (session.isGivenUp) return;
    const isKnown = sessionTable.get(session.id) === session;
    const shouldStart = isLive && description.startWithMaster;
    sessionLibrary.remember(session, isKnown && (sessionLibrary.remembersAll || shouldStart)); // [SE-24] [CU-33]
  });
  const { masterId } = nodes;
  localNode.onStarted.add((moduleId) => void reports.handleRuntime(masterId, moduleId, true));
  localNode.onStopped.add((moduleId) => void reports.handleRuntime(masterId, moduleId, false));
  localNode.onFailed.add((...failure) => reports.handleFailed(masterId, ...failure));
  localNode.onEvent.add((event) => reports.handleEvent(masterId, event));
  clients.onPresence.add(({ id }) => {
    if (nodes.get(id)?.isAvailable === true) return handleNodeBack(life, id);
    lockstep.handleNodeGone(id);
    handleNodeGone(life, id);
  });
}
