import type { Core } from '../areas/core.ts';
import { counter, gauge } from './make-families.ts';
import type { MetricFamily } from './metric-family.ts';

/** Metrics of a master among others; none of a master that is alone. [CU-40] */
export function readClusterMetrics({
  masters,
  counters,
}: Pick<Core, 'masters' | 'counters'>): MetricFamily[] {
  if (masters === undefined) return [];
  return [
    gauge('ubii_cluster_masters', 'Other masters that are heard.', masters.members.list().length),
    gauge('ubii_cluster_reachable', '1 when the bus can be reached.', masters.isReachable ? 1 : 0),
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
      'ubii_cluster_gaps_total',
      'Times that something was missing of what other masters told.',
      masters.gaps,
    ),
  ];
}
