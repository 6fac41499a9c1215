import { Cluster } from '../cluster/cluster.ts';
import type { AccessArea } from './access.ts';
import type { ClientArea } from './clients.ts';
import type { Foundation } from './foundation.ts';
import { nameOf, type ClusterPorts, type MasterPorts } from './settings.ts';
import type { TopicArea } from './topics.ts';

/** This master among others. */
export type ClusterArea = ReturnType<typeof createCluster>;

export type ClusterDependencies = Pick<MasterPorts, 'clock' | 'log'> & {
  readonly cluster?: ClusterPorts;
} & Pick<Foundation, 'id' | 'settings' | 'limits' | 'counters' | 'onClose'> &
  TopicArea &
  Pick<ClientArea, 'clients' | 'devices' | 'info'> &
  Pick<AccessArea, 'access'>;

/** Nothing is told and asked without a cluster. */
export function createCluster(dependencies: ClusterDependencies): { masters: Cluster | undefined } {
  const { cluster, settings, access } = dependencies;
  if (cluster === undefined) return { masters: undefined };
  const masters = new Cluster({
    ...dependencies,
    bus: cluster.bus,
    grants: access.grants,
    self: () => ({
      name: nameOf(settings),
      addresses: settings.endpoints().addresses.map(({ url }) => url ?? ''),
    }),
  });
  dependencies.onClose.add(() => masters.close());
  return { masters };
}
