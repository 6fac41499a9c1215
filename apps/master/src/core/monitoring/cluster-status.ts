import {
  ClusterMasterState,
  SessionStatus,
  StatusProblemSeverity,
  type ClusterMaster,
  type ClusterStatus,
  type Init,
} from '@ubii/proto';
import type { Core } from '../areas/core.ts';
import { nameOf } from '../areas/settings.ts';
import type { Problem } from '../checks/problem.ts';
import type { Cluster } from '../cluster/cluster.ts';

/** Dependencies of the status of the cluster. */
export type ClusterStatusContext = Pick<Core, 'id' | 'clock' | 'settings' | 'startedMs'> &
  Pick<Core, 'masters' | 'clients' | 'sessions' | 'foreignSessions'>;

/** A master of the cluster; members that are missing are zero. */
type DescribedMaster = Omit<Init<ClusterMaster>, 'id'> & { readonly id: string };

/** Describes the cluster as this master sees it; undefined for a master that is alone. [CU-72] */
export function readClusterStatus(core: ClusterStatusContext): Init<ClusterStatus> | undefined {
  const { masters, startedMs } = core;
  if (masters === undefined) return undefined;
  const clients = countClients(core);
  const sessions = countSessions(core);
  const withCounts = (master: DescribedMaster): DescribedMaster => ({
    ...master,
    clients: clients.get(master.id) ?? 0,
    sessions: sessions.get(master.id) ?? 0,
  });
  return {
    name: masters.name,
    reachable: masters.isReachable,
    reachableSinceMs: masters.reachSinceMs ?? startedMs,
    queuedBytes: masters.queuedBytes,
    gaps: masters.peers.gaps,
    masters: [describeSelf(core), ...present(masters), ...absent(core, masters)].map(withCounts),
  };
}

/** A master that is cut off from the others is a problem of its own. [CU-75] */
export function* clusterProblems({ masters }: Pick<Core, 'masters'>): Iterable<Problem> {
  if (masters === undefined || masters.isReachable || masters.reachSinceMs === undefined) return;
  yield {
    code: 'cluster_unreachable',
    severity: StatusProblemSeverity.ERROR,
    text: 'This master cannot reach NATS, and works alone. Clients of other masters count as lost, and masters that reach NATS take over its sessions, which run twice until NATS is back.',
    remedy:
      'Check that NATS runs, and the network between it and this master. The master connects again automatically.',
    sinceMs: masters.reachSinceMs,
  };
}

function describeSelf({ id, settings, startedMs }: ClusterStatusContext): DescribedMaster {
  return {
    id,
    name: nameOf(settings),
    state: ClusterMasterState.SELF,
    sinceMs: startedMs,
    version: settings.version,
    startedMs,
    addresses: settings.endpoints().addresses.flatMap(({ url }) => url ?? []),
    complete: true,
  };
}

function present(masters: Cluster): DescribedMaster[] {
  return masters.members.list().map((member) => ({
    ...masters.peers.get(member.id)?.describe(),
    ...member,
    state: ClusterMasterState.PRESENT,
  }));
}

function absent({ clock }: ClusterStatusContext, masters: Cluster): DescribedMaster[] {
  return masters.lost.list(clock.nowMs()).map(({ member, hasEnded, sinceMs }) => ({
    ...member,
    state: hasEnded ? ClusterMasterState.ENDED : ClusterMasterState.LOST,
    sinceMs,
  }));
}

/** Clients by the id of their master. */
function countClients({ id, clients }: ClusterStatusContext): Map<string, number> {
  const counts = new Map<string, number>();
  for (const { home, status } of clients.values()) {
    if (status !== 'unavailable') add(counts, home?.masterId ?? id);
  }
  return counts;
}

/** Sessions that run, by the id of their master. */
function countSessions({
  id,
  sessions,
  foreignSessions,
}: ClusterStatusContext): Map<string, number> {
  const counts = new Map<string, number>();
  for (const { isLive } of sessions.list()) if (isLive) add(counts, id);
  for (const [sessionId, masterId] of foreignSessions.masters()) {
    const status = foreignSessions.get(sessionId)?.status;
    const isRunning = status === SessionStatus.RUNNING || status === SessionStatus.PAUSED;
    if (isRunning && !sessions.isOpen(sessionId)) add(counts, masterId);
  }
  return counts;
}

function add(counts: Map<string, number>, key: string): void {
  counts.set(key, (counts.get(key) ?? 0) + 1);
}
