import type { Core } from '../areas/core.ts';
import { counter, gauge } from './make-families.ts';
import type { MetricFamily } from './metric-family.ts';

/** Metrics of a master among others; none of a master that is alone. [CU-40] */
export function readClusterMetrics({
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
