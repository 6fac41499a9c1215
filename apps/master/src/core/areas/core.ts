import type { Answer } from '../cluster/calls.ts';
import { createAccess, type AccessArea } from './access.ts';
import { createBridges, type BridgeArea } from './bridges.ts';
import { createCluster, type ClusterArea } from './cluster.ts';
import { createClients, type ClientArea } from './clients.ts';
import { createFoundation, type Foundation } from './foundation.ts';
import { createLibrary, type LibraryArea } from './library.ts';
import { createMonitoring, type MonitoringArea } from './monitoring.ts';
import { createNodes, type NodeArea } from './nodes.ts';
import { createSessions, type SessionArea } from './sessions.ts';
import { createRecordings, type RecordingArea } from './recordings.ts';
import { createReplays, type ReplayArea } from './replays.ts';
import type { MasterPorts, MasterSettings } from './settings.ts';
import { createStudies, type StudyArea } from './studies.ts';
import { createTopics, type TopicArea } from './topics.ts';

/** Ports that services use. */
type ServicePorts = Pick<
  MasterPorts,
  'clock' | 'log' | 'logTail' | 'tokens' | 'patterns' | 'lan' | 'assetSets'
>;

/** Members of all areas. Services and status name those that they use. */
export interface Core
  extends
    ServicePorts,
    Foundation,
    TopicArea,
    ClientArea,
    LibraryArea,
    NodeArea,
    SessionArea,
    AccessArea,
    RecordingArea,
    ReplayArea,
    StudyArea,
    BridgeArea,
    ClusterArea,
    MonitoringArea {}

/**
 * Creates the areas of a master in order. Each is given the parts of those before it.
 *
 * @param answer Answers requests of other masters for their clients. [CU-28]
 */
export function createCore(ports: MasterPorts, settings: MasterSettings, answer: Answer): Core {
  const foundation = { ...ports, ...createFoundation(ports, settings) };
  const topics = { ...foundation, ...createTopics(foundation) };
  const clients = { ...topics, ...createClients(topics) };
  const library = { ...clients, ...createLibrary(clients) };
  const nodes = { ...library, ...createNodes(library) };
  const sessions = { ...nodes, ...createSessions({ ...nodes, isOtherMaster }) };
  const access = { ...sessions, ...createAccess(sessions) };
  const recordings = { ...access, ...createRecordings(access) };
  const replays = { ...recordings, ...createReplays(recordings) };
  const studies = { ...replays, ...createStudies(replays) };
  const bridges = { ...studies, ...createBridges(studies) };
  const cluster = { ...bridges, ...createCluster({ ...bridges, answer }) };
  function isOtherMaster(id: string): boolean {
    return cluster.masters?.isMaster(id) === true;
  }
  return { ...cluster, ...createMonitoring(cluster) };
}
