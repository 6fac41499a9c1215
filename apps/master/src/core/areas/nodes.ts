import { createModuleRuntime } from '@ubii/pm-sandbox';
import { LocalNode } from '../nodes/local-node.ts';
import { LocalTopics } from '../nodes/local-topics.ts';
import { masterExtension, NodeTable } from '../nodes/node-table.ts';
import { SessionTable } from '../sessions/session-table.ts';
import type { ClientArea } from './clients.ts';
import type { Foundation } from './foundation.ts';
import type { LibraryArea } from './library.ts';
import { nameOf, type MasterPorts } from './settings.ts';
import type { TopicArea } from './topics.ts';

/** Nodes, which run modules: the master, and clients. */
export type NodeArea = ReturnType<typeof createNodes>;

export type NodeAreaContext = Pick<
  MasterPorts,
  'clock' | 'patterns' | 'sandboxes' | 'assets' | 'cluster'
> &
  Pick<Foundation, 'id' | 'settings' | 'limits' | 'limitWatch' | 'counters'> &
  Pick<TopicArea, 'accounts' | 'topics' | 'kept' | 'tap' | 'replayed' | 'subscriptions'> &
  Pick<TopicArea, 'recordedSources'> &
  Pick<ClientArea, 'clients' | 'devices'> &
  Pick<LibraryArea, 'modules'>;

/** Default number of modules that a master accepts: the load used for measurements. */
const DEFAULT_CAPACITY = 100;

/** Nothing runs until a session starts. */
export function createNodes(context: NodeAreaContext) {
  const { id: nodeId, settings, limits, limitWatch, accounts, clients, devices } = context;
  const { assets, modules } = context;
  const { libraries = [], capacity = DEFAULT_CAPACITY } = settings;
  const nodes = new NodeTable(
    {
      id: nodeId,
      name: nameOf(settings),
      extension: masterExtension(libraries, capacity, limits.moduleBytes, assets !== undefined),
      modules: () => modules.list(),
    },
    clients,
  );
  const sessionTable = new SessionTable(context.cluster && nodeId);
  const localTopics = new LocalTopics({
    ...context,
    nodeId,
    account: accounts.createSession(nodeId),
    deviceOf: (topic) => devices.deviceOfTopic(topic),
    isSession: (id) => sessionTable.get(id) !== undefined,
    onLimit: (limit) => limitWatch.count(limit, nodeId),
  });
  const { clock, patterns, sandboxes } = context;
  const localNode = new LocalNode((hooks) =>
    createModuleRuntime({
      nodeId,
      clock,
      topics: localTopics,
      patterns,
      sandboxes,
      libraries,
      assets,
      limits: { maxTopics: limits.topicsPerModule },
      ...hooks,
    }),
  );
  return {
    /** Open sessions, whose modules run on nodes. */
    sessionTable,
    nodes,
    localNode,
    /** The topics as modules on the master see them. */
    localTopics,
  };
}
