import type { Core } from '../areas/core.ts';
import { counter, gauge, family } from './metric-family.ts';
import type { MetricFamily, MasterMetrics } from './metric-family.ts';
import { SESSION_LIVES } from '../sessions/session-states.ts';

/** Metrics of a master among others; none of a master that is alone. [CU-40] */
function readClusterMetrics({
  masters,
  clients,
  foreignSessions,
  counters,
}: Pick<Core, 'masters' | 'clients' | 'foreignSessions' | 'counters'>): MetricFamily[] {
  if (masters === undefined) return [];
  const elsewhere = [...clients.values()].filter(({ home }) => home?.isLost === false).length;
  const { length: members } = masters.members.list();
  return [
    gauge('ubii_cluster_masters', 'Other masters that are heard.', members),
    gauge(
      'ubii_cluster_masters_complete',
      'Other masters of which all that they have was received.',
      masters.peers.completeCount,
    ),
    gauge('ubii_cluster_reachable', '1 when the bus can be reached.', masters.isReachable ? 1 : 0),
    gauge('ubii_cluster_clients', 'Clients of other masters that are heard.', elsewhere),
    gauge(
      'ubii_cluster_sessions',
      'Open sessions of other masters.',
      foreignSessions.masters().length,
    ),
    counter(
      'ubii_cluster_records_sent_total',
      'Records sent to other masters, once for each.',
      counters.recordsToMasters,
    ),
    counter(
      'ubii_cluster_records_received_total',
      'Records received from other masters.',
      counters.recordsFromMasters,
    ),
    counter(
      'ubii_cluster_records_dropped_total',
      'Records dropped from the queues to other masters.',
      masters.peers.dropped,
    ),
    counter(
      'ubii_cluster_sent_bytes_total',
      'Bytes of messages sent to other masters; those to all count once.',
      masters.bytes.to,
    ),
    counter(
      'ubii_cluster_received_bytes_total',
      'Bytes of messages received from other masters.',
      masters.bytes.from,
    ),
    gauge(
      'ubii_cluster_queued_bytes',
      'Bytes sent to other masters that the bus has not taken yet.',
      masters.queuedBytes,
    ),
    counter(
      'ubii_cluster_gaps_total',
      'Times that something was missing of what other masters sent, and was asked for again.',
      masters.peers.gaps,
    ),
  ];
}

/** Dependencies of metrics. */
type MetricContext = Pick<Core, 'counters' | 'limits' | 'limitWatch' | 'topics' | 'clients'> &
  Pick<
    Core,
    'devices' | 'sockets' | 'connections' | 'bodies' | 'sessions' | 'localNode' | 'masters'
  > &
  Pick<Core, 'foreignSessions'>;

/** Every metric. Labels come from closed lists: limits, codes, states, services; never ids or topics. */
export function readMetrics(core: MetricContext): MasterMetrics {
  const { counters, clients, devices, topics, sockets, limitWatch, limits } = core;
  const hits = new Map([...limitWatch.hits()].map((hit) => [hit.limit, hit.streak.count]));
  const waiting = [...clients.values()].map((client) => client.subscriber.outbox.waitingCount);
  return [
    counter('ubii_records_received_total', 'Records published by clients.', counters.recordsIn),
    counter('ubii_records_sent_total', 'Records delivered to subscribers.', counters.recordsOut),
    counter(
      'ubii_received_bytes_total',
      'Encoded bytes of records published by clients.',
      counters.bytesIn,
    ),
    counter(
      'ubii_sent_bytes_total',
      'Encoded bytes of records delivered to subscribers.',
      counters.bytesOut,
    ),
    counter(
      'ubii_records_dropped_total',
      'Records dropped from the queues of slow subscribers.',
      counters.dropped,
    ),
    family(
      'ubii_refused_total',
      'Records and requests refused, by reason.',
      'counter',
      'code',
      Object.entries(counters.refused),
    ),
    counter(
      'ubii_protocol_errors_total',
      'Messages on topic-data sockets that cannot be decoded.',
      counters.protocolErrors,
    ),
    family(
      'ubii_limit_hits_total',
      'Number of times that a limit was reached.',
      'counter',
      'limit',
      Object.keys(limits).map((limit) => [limit, hits.get(limit as keyof typeof limits) ?? 0]),
    ),
    family('ubii_service_requests_total', 'Service requests, by service.', 'counter', 'service', [
      ...counters.requests,
    ]),
    counter(
      'ubii_service_requests_failed_total',
      'Service requests answered with an error.',
      counters.failedRequests,
    ),
    gauge(
      'ubii_request_bytes_in_flight',
      'Bytes of service requests that are being received or decoded.',
      core.bodies.totalBytes,
    ),
    gauge('ubii_connections', 'Open connections to all ports.', core.connections.size),
    gauge(
      'ubii_connections_of_strangers',
      'Open connections of callers that have not joined.',
      core.connections.strangers,
    ),
    counter('ubii_sockets_opened_total', 'Topic-data sockets opened.', counters.connectionsOpened),
    counter(
      'ubii_sockets_refused_total',
      'Topic-data sockets refused.',
      counters.connectionsRefused,
    ),
    gauge('ubii_sockets', 'Open topic-data sockets.', sockets.openCount),
    family(
      'ubii_clients',
      'Registered clients, by state.',
      'gauge',
      'state',
      Object.entries(clients.countByStatus()).filter(([state]) => state !== 'removed'),
    ),
    family('ubii_sessions', 'Sessions, by state.', 'gauge', 'state', countSessions(core)),
    gauge(
      'ubii_module_instances',
      'Processing modules that run on the master.',
      core.localNode.instanceCount,
    ),
    ...moduleTotals(core),
    gauge('ubii_devices', 'Registered devices.', devices.size),
    gauge('ubii_topics', 'Topics with a value or a subscription.', topics.size),
    gauge('ubii_retained_bytes', 'Encoded bytes of all retained records.', topics.retainedBytes),
    gauge(
      'ubii_records_waiting',
      'Records queued for slow sockets.',
      waiting.reduce((sum, count) => sum + count, 0),
    ),
    ...readClusterMetrics(core),
  ];
}

/** Every state, those without a session too. */
function countSessions({ sessions }: MetricContext): [string, number][] {
  const counts = new Map<string, number>(SESSION_LIVES.map((life) => [life, 0]));
  for (const { life } of sessions.list()) counts.set(life, counts.get(life)! + 1);
  return [...counts];
}

/** Totals of all modules of live sessions since their creation, on all nodes. */
function moduleTotals({ sessions }: MetricContext): MetricFamily[] {
  const statistics = sessions
    .list()
    .filter(({ isLive }) => isLive)
    .flatMap(({ modules }) => modules.flatMap((module) => module.statistics ?? []));
  const sum = (key: 'runs' | 'errors' | 'overruns' | 'restarts' | 'outputs' | 'outputsRefused') =>
    statistics.reduce((total, one) => total + one[key], 0);
  return [
    gauge('ubii_module_runs', 'Runs of the modules that exist now.', sum('runs')),
    gauge('ubii_module_errors', 'Failed runs of the modules that exist now.', sum('errors')),
    gauge('ubii_module_overruns', 'Overruns of the modules that exist now.', sum('overruns')),
    gauge('ubii_module_restarts', 'Restarts of the modules that exist now.', sum('restarts')),
    gauge(
      'ubii_module_outputs',
      'Records published by the modules that exist now.',
      sum('outputs'),
    ),
    gauge(
      'ubii_module_outputs_refused',
      'Refused outputs of the modules that exist now.',
      sum('outputsRefused'),
    ),
  ];
}
