import { StatusEventKind, type ServiceRequest } from '@ubii/proto';
import { TextCache } from '@ubii/proto/wire';
import { EndOfTurn } from '@ubii/timing';
import { Access } from '../access/access.ts';
import { watchGrants } from '../services/grant-work.ts';
import { Grants } from '../access/grants.ts';
import { GuessLimit } from '../access/guess-limit.ts';
import { openTerminal } from '../access/open-terminal.ts';
import { topicRightsOf } from '../access/topic-rights.ts';
import { AuditLog } from '../audit/audit-log.ts';
import { DEFAULT_CHECKS } from '../checks/check-settings.ts';
import { OverloadChecks } from '../checks/overload-checks.ts';
import { ClientRegistry } from '../clients/client-registry.ts';
import { CLOSE } from '../clients/close-codes.ts';
import { ClientMeter } from '../clients/client-meter.ts';
import { Dismissals } from '../clients/dismissals.ts';
import { Liveness } from '../clients/liveness.ts';
import { SocketAdmission } from '../clients/socket-admission.ts';
import { Connections } from '../connections/connections.ts';
import type { Core } from '../parts/core.ts';
import { DeviceRegistry } from '../devices/device-registry.ts';
import { InfoTopics } from '../info/info-topics.ts';
import { MasterPublisher } from '../info/master-publisher.ts';
import { DEFAULT_LIMITS, type Limits } from '../limits/index.ts';
import type {
  ConnectionPeer,
  ConnectionQuery,
  Master,
  MasterMetrics,
  ServiceAnswer,
  TerminalAccess,
} from './master.ts';
import type { Role } from '../access/roles.ts';
import type { CallerFacts } from '../ports/caller-facts.ts';
import type { ClientConnection } from '../ports/client-connection.ts';
import type { ConnectionHandle } from '../ports/connection-handle.ts';
import { BodyAccounts } from '../connections/body-accounts.ts';
import { IncomingRequest } from '../services/incoming-request.ts';
import { answerRequest, refuse } from '../services/router.ts';
import type { MasterPorts, MasterSettings } from '../parts/settings.ts';
import { Counters } from '../counters/counters.ts';
import { EventLog } from '../counters/event-log.ts';
import { LimitWatch } from '../counters/limit-watch.ts';
import { tellOfGone } from '../nodes/local-topics.ts';
import { createProcessing } from './create-processing.ts';
import type { Processing } from '../parts/processing.ts';
import type { RestoreReport, SessionsAtStop } from '../sessions/restored-sessions.ts';
import { Accounts } from '../shares/accounts.ts';
import { readMetrics } from '../monitoring/metrics.ts';
import { Load } from '../counters/load.ts';
import { Samples } from '../counters/samples.ts';
import { ExpiringValues } from '../topics/expiring-values.ts';
import { KeptValues } from '../topics/kept-values.ts';
import { PatternTable } from '../topics/pattern-table.ts';
import { SelectionTable } from '../topics/selection-table.ts';
import { subscriberFactory } from '../topics/subscriber-factory.ts';
import { SubscriptionTable } from '../topics/subscription-table.ts';
import { TopicTable } from '../topics/topic-table.ts';
import { TurnBatches } from '../topics/turn-batches.ts';

/** Creates a master. Until its first call, it only measures time. */
export function createMaster(ports: MasterPorts, settings: MasterSettings): Master {
  const core = createCore(ports, { ...DEFAULT_LIMITS, ...settings.limits }, settings);
  const liveness = new Liveness(core.clock, core.clients, core.limits, core.kept);
  const expiring = new ExpiringValues(core);
  core.processing.sessions.restore((grantId) => core.access.grants.isGood(grantId)); // [SE-24]
  const stopWatchingGrants = watchGrants(core);
  return {
    id: core.id,
    admitConnection(peer, cut) {
      return core.connections.admit(peer, cut);
    },
    openRequest(caller: CallerFacts, connection: object): IncomingRequest {
      return new IncomingRequest(core, caller, connection);
    },
    handleServiceRequest(
      request: ServiceRequest,
      caller: CallerFacts,
      incoming?: IncomingRequest,
    ): Promise<ServiceAnswer> {
      return answerRequest(core, request, caller, incoming?.caller);
    },
    refuseServiceRequest(cause: unknown): ServiceAnswer {
      return refuse(core, cause);
    },
    refuseConnection(query: ConnectionQuery, caller: CallerFacts): string | undefined {
      return core.sockets.refuse(query, caller);
    },
    openConnection(
      query: ConnectionQuery,
      connection: ClientConnection,
      caller: CallerFacts,
      peer?: ConnectionPeer,
    ): ConnectionHandle | undefined {
      return core.sockets.open(query, connection, caller, peer);
    },
    roleOf(caller: CallerFacts): Role {
      return core.access.identify(caller).role;
    },
    recognizes(caller: CallerFacts): boolean {
      const { kind } = core.access.identify(caller);
      return kind === 'client' || kind === 'joining';
    },
    openTerminal(isReachable: boolean): Promise<TerminalAccess> {
      return openTerminal(core, isReachable);
    },
    metrics(): MasterMetrics {
      return readMetrics(core);
    },
    sessionsAtStop(): SessionsAtStop {
      return core.processing.sessions.atStop();
    },
    sessionsRestored(): Promise<RestoreReport> {
      return core.processing.sessions.restored.report();
    },
    async close(): Promise<void> {
      liveness.close();
      expiring.close();
      stopWatchingGrants();
      core.connections.close();
      core.samples.close();
      core.load.close();
      core.info.close();
      for (const { socket } of core.clients.values()) {
        socket?.close(CLOSE.goingAway.code, CLOSE.goingAway.reason);
      }
      await core.processing.close();
    },
  };
}

/** The parts of a master, each given what it works on. */
function createCore(ports: MasterPorts, limits: Limits, settings: MasterSettings): Core {
  const { clock, log } = ports;
  const startedMs = clock.nowMs();
  const id = ports.ids.uuid();
  const counters = new Counters();
  const events = new EventLog(clock, log, limits);
  const limitWatch = new LimitWatch(limits, clock, log, events);

  const accounts = new Accounts({
    clock,
    limits: limitWatch,
    makeRoom: (shortage, hasRoom) => clients.makeRoom(shortage, hasRoom),
  });

  const patterns = new PatternTable({
    clock,
    compiler: ports.patterns,
    onOverdrawn(subscriber) {
      limitWatch.count('patternMatchMs', subscriber.clientId);
      subscriptions.unsubscribePatterns(subscriber);
      const text = `Matching the regular expressions of this client took more than ${limits.patternMatchMs} ms (limit patternMatchMs), so they were ended. Subscribe with simpler expressions.`;
      clients.get(subscriber.clientId)?.socket?.sendError('resource_exhausted', text);
    },
  });
  const selections = new SelectionTable();
  // A thousand epochs fit into each millisecond that earlier runs of the master lasted.
  const topics = new TopicTable(
    [patterns, selections],
    startedMs * 1000,
    limits.keptRemovals,
    accounts.master,
    (entry) => tellOfGone(publishing, entry),
  );
  const subscriptions: SubscriptionTable = new SubscriptionTable({
    topics,
    patterns,
    selections,
    limits: limitWatch,
    accounts,
    components: () => devices.components(),
  });
  const kept = new KeptValues({ clock, limits, topics, accounts });
  const publishing = { topics, subscriptions, limits, accounts, counters, kept };
  const batches = new TurnBatches();
  const endOfTurn = new EndOfTurn(clock, () => batches.renew());
  const publisher = new MasterPublisher(publishing, clock);
  const info = new InfoTopics(publisher, clock, limits);

  const shared = { ...ports, limits: limitWatch, events, topics, subscriptions, info, accounts };
  const devices: DeviceRegistry = new DeviceRegistry(shared);
  const dismissals = new Dismissals();
  const access = new Access({
    clock,
    secrets: ports.accessSecrets,
    tokens: ports.tokens,
    grants: new Grants({
      ...ports,
      secrets: ports.accessSecrets,
      store: ports.grants,
      limits: limitWatch,
    }),
    guesses: new GuessLimit(clock, limitWatch),
    accessOf: (clientId) => clients.get(clientId)?.access,
  });
  const namespaces = {
    isClient: (clientId: string) => clients.get(clientId) !== undefined,
    isInputOf: (clientId: string, topic: string) => devices.isInputOf(clientId, topic),
  };
  const clients: ClientRegistry = new ClientRegistry({
    ...shared,
    kept,
    devices,
    dismissals,
    createSubscriber: subscriberFactory({ ...publishing, clock, endOfTurn, batches }),
    topicRightsOf: (clientId, { role, grant }) =>
      topicRightsOf(clientId, role, grant, namespaces, ports.patterns),
    onPresence: (client) => processing.handlePresence(client.id),
  });
  const sockets = new SocketAdmission({
    ...ports,
    ...publishing,
    endOfTurn,
    topicTexts: new TextCache(),
    limitWatch,
    clients,
    access,
    dismissals,
    onSign: (client) => clients.handleSign(client),
    onClosed: (socket, hasLeft) => sockets.handleClosed(socket, hasLeft),
    onNodeMessage: (client, bytes) => processing.reports.handleMessage(client, bytes),
  });
  const processing: Processing = createProcessing({
    ports,
    settings,
    masterId: id,
    limitWatch,
    events,
    clients,
    devices,
    publishing,
    publisher,
  });
  const clientMeter = new ClientMeter(clients);
  const load: Load = new Load(clock, ports.usage, (seconds) => {
    clientMeter.measure(seconds);
    checks.look();
  });
  const checks = new OverloadChecks({
    clock,
    limits,
    events,
    clients,
    settings: { ...DEFAULT_CHECKS, ...settings.checks },
    load: () => load,
    nodes: processing.nodes,
    sessions: () => processing.sessions.list(),
  });
  const samples = new Samples(clock, load, counters);
  events.add(StatusEventKind.MASTER_STARTED, 'The master started');
  return {
    ...ports,
    id,
    startedMs,
    settings,
    limits,
    access,
    bodies: new BodyAccounts(limits, limitWatch),
    connections: new Connections(clock, limitWatch),
    topics,
    kept,
    patternTable: patterns,
    selectionTable: selections,
    subscriptions,
    clients,
    sockets,
    devices,
    accounts,
    info,
    processing,
    counters,
    limitWatch,
    events,
    audit: new AuditLog({ clock, limits, audit: ports.audit }),
    samples,
    load,
    checks,
    clientMeter,
  };
}
