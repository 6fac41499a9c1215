import { createModuleRuntime, type ModuleFault } from '@ubii/pm-sandbox';
import { StatusEventKind } from '@ubii/proto';
import { readRecordHead } from '@ubii/proto/wire';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { DeviceRegistry } from '../devices/device-registry.ts';
import type { MasterPublisher } from '../info/master-publisher.ts';
import { MASTER_ALIAS, SessionLibrary } from '../sessions/session-library.ts';
import { FileNews } from '../library/file-news.ts';
import { ModuleHistory } from '../library/module-history.ts';
import { ModuleLibrary } from '../library/module-library.ts';
import { watchModuleFiles } from '../library/stored-module-versions.ts';
import { StoredMessages } from '../library/stored-messages.ts';
import { LocalNode, type RuntimeHooks } from '../nodes/local-node.ts';
import { LocalTopics } from '../nodes/local-topics.ts';
import { masterExtension, NodeTable } from '../nodes/node-table.ts';
import type { Processing } from '../parts/processing.ts';
import { nameOf, type MasterPorts, type MasterSettings } from '../parts/settings.ts';
import type { EventLog } from '../counters/event-log.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { PublishContext } from '../topics/publisher.ts';
import { quote } from '../texts/quote.ts';
import { createChecks } from '../sessions/checks/create-checks.ts';
import type { DraftContext } from '../sessions/draft-maker.ts';
import type { LifeContext } from '../sessions/life-context.ts';
import { Lockstep } from '../sessions/lockstep/lockstep.ts';
import { handleFailed, handleStarted, handleStopped } from '../sessions/module-reports.ts';
import { handleNodeBack, handleNodeGone } from '../sessions/node-changes.ts';
import { NodeReports } from '../sessions/node-reports.ts';
import { ModuleReload } from '../sessions/reload-modules.ts';
import type { Session } from '../sessions/session.ts';
import { SessionNews } from '../sessions/session-news.ts';
import { SessionTable } from '../sessions/session-table.ts';
import { RunTroubles } from '../sessions/run-troubles.ts';
import { Sessions } from '../sessions/sessions.ts';
import { Supervision } from '../sessions/supervision.ts';
import { TopicTroubles } from '../sessions/topic-troubles.ts';

/** Dependencies of sessions and modules. */
export interface ProcessingParts {
  readonly ports: MasterPorts;
  readonly settings: MasterSettings;
  readonly masterId: string;
  readonly limitWatch: LimitWatch;
  readonly events: EventLog;
  readonly clients: ClientRegistry;
  readonly devices: DeviceRegistry;
  readonly publishing: PublishContext;
  readonly publisher: MasterPublisher;
}

/** How many modules a master likes to run: the load the design was measured with. */
const DEFAULT_CAPACITY = 100;

/** Puts together what sessions and modules need. Nothing runs until a session starts. */
export function createProcessing(parts: ProcessingParts): Processing {
  const { ports, settings, masterId, limitWatch, clients, devices, publishing, publisher } = parts;
  const { events } = parts;
  const { clock, log, ids, storage, sandboxes, assets, patterns } = ports;
  const { limits } = limitWatch;
  const storedSessions = new StoredMessages(storage.sessions, 'ubii.sessions.Session');
  const storedModules = new StoredMessages(storage.modules, 'ubii.processing.ProcessingModule');
  const modules = new ModuleLibrary(ports.library, storedModules);
  const running = new StoredMessages(storage.running, 'ubii.sessions.Session');
  const files = new FileNews({ log, events }, [storedSessions, storedModules, running]);
  const sessionLibrary = new SessionLibrary({
    stored: storedSessions,
    running,
    masterId,
    log,
    ids,
  });

  const history = new ModuleHistory({ store: storage.history, clock, log });
  const unwatchModules = watchModuleFiles(history, storedModules);

  const { libraries = [], capacity = DEFAULT_CAPACITY } = settings;
  const nodes = new NodeTable(
    {
      id: masterId,
      name: nameOf(settings),
      extension: masterExtension(libraries, capacity, limits.moduleBytes, assets !== undefined),
      modules: () => modules.list(),
    },
    clients,
  );
  const table = new SessionTable();
  const localTopics = new LocalTopics({
    ...publishing,
    clock,
    nodeId: masterId,
    account: publishing.accounts.createSession(masterId),
    deviceOf: (topic) => devices.deviceOfTopic(topic),
    isSession: (id) => table.get(id) !== undefined,
    onLimit: (limit) => limitWatch.count(limit, masterId),
  });
  const createRuntime = (hooks: RuntimeHooks) =>
    createModuleRuntime({
      nodeId: masterId,
      clock,
      topics: localTopics,
      patterns,
      sandboxes,
      libraries,
      assets,
      limits: { maxTopics: limits.topicsPerModule },
      ...hooks,
    });
  const local: LocalNode = new LocalNode(createRuntime, {
    onStarted: (moduleId) => void handleReport(masterId, moduleId, true),
    onStopped: (moduleId) => void handleReport(masterId, moduleId, false),
    onFailed(moduleId, reason, fault) {
      if (fault?.shortage !== undefined) noteShortage(moduleId, fault.shortage);
      reportFailed(masterId, moduleId, reason, fault);
    },
    onEvent: (event) => reports.handleEvent(masterId, event),
  });
  const { topics, subscriptions } = publishing;
  const news = new SessionNews({ publisher, topics, subscriptions, clock, limits });
  const life: LifeContext = {
    clock,
    limits,
    log,
    clients,
    nodes,
    local,
    news,
    sessions: () => table.values(),
    loadOf: (node) => table.loadOf(node.id),
    onLife(session) {
      supervision.handleLife(session);
      sessions.restored.handleLife();
      life.onModules(session);
      if (session.life === 'degraded') {
        events.add(
          StatusEventKind.SESSION_DEGRADED,
          `The session ${quote(session.label)} runs without some of its modules`,
        );
      }
    },
    onModules(session) {
      lockstep.handleLife(session);
      rememberIfWished(session);
    },
  };
  const lockstep = new Lockstep({
    clock,
    limits,
    clients,
    nodes,
    local,
    news,
    topics: localTopics,
    patterns,
    publish(record, client, sessionId) {
      const { topic, valueField } = readRecordHead(record);
      localTopics.publishAs(client, topic, record, valueField, sessionId);
    },
  });
  const runTroubles = new RunTroubles({
    monotonicMs: () => clock.monotonicMs(),
    onChange: (session) => news.announceChange(session),
  });
  const reports = new NodeReports({
    limits,
    table,
    news,
    lockstep,
    clock,
    topics,
    onEvent: (session, module, event) => runTroubles.handleEvent(session, module, event),
    onFailed: (nodeId, { moduleId, message, line, column }) =>
      reportFailed(nodeId, moduleId, message, { line, column }),
  });
  const drafts: DraftContext = {
    limits: limitWatch,
    completion: {
      uuid: () => ids.uuid(),
      isTaken: (id) => table.findModule(id) !== undefined,
      nodeId: (text) => (text === MASTER_ALIAS ? masterId : text),
      stored: (name) => modules.get(name),
      offered: (name, nodeId) => nodes.offered(name, nodeId),
    },
    checks: createChecks({ patterns, devices, nodes, topics, clients, limits }),
    sources: { sandboxes, clock, timeoutMs: limits.sourceCheckTimeoutMs },
  };
  const sessions = new Sessions({
    ids,
    limits: limitWatch,
    table,
    drafts,
    life,
    library: sessionLibrary,
    history,
    topics: localTopics,
  });
  const topicTroubles = new TopicTroubles({
    monotonicMs: () => clock.monotonicMs(),
    onRunaway(_session, { nodeId }, text) {
      limitWatch.count('topicsPerModule', nodeId);
      events.add(StatusEventKind.LIMIT_REACHED, text, nodeId);
    },
    onChange: (session) => news.announceChange(session),
  });
  const supervision = new Supervision(life, {
    passes: (session) => lockstep.statistics(session),
    recheck: (session) => sessions.recheck(session),
    lookAtTroubles(session) {
      topicTroubles.look(session);
      runTroubles.look(session);
    },
  });

  const reload = new ModuleReload({ library: modules, sessions, news });

  let isClosed = false;
  /** [SE-24] */
  function rememberIfWished(session: Session): void {
    if (isClosed) return;
    const isKnown = table.get(session.id) === session;
    sessionLibrary.remember(
      session,
      isKnown && session.isLive && session.description.startWithMaster,
    );
  }
  /** A module on the master did not get memory [SE-65]. */
  function noteShortage(moduleId: string, shortage: 'all' | 'owner'): void {
    const found = table.findModule(moduleId);
    if (found === undefined) return;
    limitWatch.count(shortage === 'all' ? 'moduleBytes' : 'moduleBytesPerSession', masterId);
    const { session, module } = found;
    const whose = shortage === 'all' ? 'all modules on the master' : 'the modules of its session';
    events.add(
      StatusEventKind.LIMIT_REACHED,
      `The module ${quote(module.name)} of the session ${quote(session.label)} was ended: the memory for ${whose} is used up`,
      masterId,
    );
  }
  /** Ignores reports about modules of other nodes. */
  function reportFailed(
    nodeId: string,
    moduleId: string,
    reason: string,
    place: Pick<ModuleFault, 'line' | 'column'> | undefined,
  ): void {
    const found = table.findModule(moduleId);
    if (found?.module.nodeId !== nodeId) return;
    handleFailed(life, found.session, found.module, reason, place);
  }
  function handleReport(nodeId: string, moduleId: string, isRunning: boolean): boolean {
    const found = table.findModule(moduleId);
    if (found?.module.nodeId !== nodeId) return false;
    if (isRunning) handleStarted(life, found.session, found.module);
    else handleStopped(life, found.session, found.module);
    return true;
  }
  return {
    sessions,
    modules,
    sessionLibrary,
    nodes,
    localNode: local,
    reports,
    files,
    reload,
    history,
    handleReport,
    handlePresence(clientId) {
      const node = nodes.get(clientId);
      if (node?.isAvailable === true) {
        handleNodeBack(life, clientId);
        return;
      }
      lockstep.handleNodeGone(clientId);
      handleNodeGone(life, clientId);
    },
    async close() {
      isClosed = true;
      files.close();
      news.close();
      reload.close();
      unwatchModules();
      supervision.close();
      lockstep.close();
      for (const store of [storage.sessions, storage.modules, storage.running, storage.history])
        store.close();
      await local.close();
      await sandboxes.close();
    },
  };
}
