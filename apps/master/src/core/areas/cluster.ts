import type { Answer } from '../cluster/calls.ts';
import { Cluster } from '../cluster/cluster.ts';
import type { AccessArea } from './access.ts';
import type { ClientArea } from './clients.ts';
import type { Foundation } from './foundation.ts';
import type { LibraryArea } from './library.ts';
import type { NodeArea } from './nodes.ts';
import type { SessionArea } from './sessions.ts';
import { nameOf, type MasterPorts } from './settings.ts';
import type { TopicArea } from './topics.ts';

/** This master among others. */
export interface ClusterArea {
  /** Undefined: this master is alone. */
  readonly masters: Cluster | undefined;
}

export type ClusterAreaContext = Pick<MasterPorts, 'clock' | 'log' | 'cluster'> &
  Pick<Foundation, 'id' | 'startedMs' | 'settings' | 'limits' | 'counters' | 'events' | 'onClose'> &
  TopicArea &
  Pick<ClientArea, 'clients' | 'devices' | 'info'> &
  Pick<NodeArea, 'sessionTable' | 'nodes'> &
  Pick<SessionArea, 'sessions' | 'reports' | 'sessionNews' | 'foreignSessions' | 'claims'> &
  Pick<LibraryArea, 'sessionLibrary'> &
  Pick<AccessArea, 'access'> & {
    /** Answers requests of other masters for their clients. [CU-28] */
    readonly answer: Answer;
  };

/** Without a cluster, no message is sent. */
export function createCluster(context: ClusterAreaContext): ClusterArea {
  const { cluster, settings, access, sessionNews } = context;
  if (cluster === undefined) return { masters: undefined };
  const { name, bus, seal, owners } = cluster;
  const masters = new Cluster({
    ...context,
    name,
    bus,
    seal,
    owners,
    grants: access.grants,
    onSessionNews: sessionNews.onNews,
    self: () => ({
      name: nameOf(settings),
      version: settings.version,
      startedMs: context.startedMs,
      installation: access.grants.installation,
      addresses: settings.endpoints().addresses.flatMap(({ url }) => url ?? []),
    }),
  });
  context.onClose.add(() => masters.close());
  return { masters };
}
