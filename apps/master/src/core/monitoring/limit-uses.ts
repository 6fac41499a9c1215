import type { Init, LimitUse } from '@ubii/proto';
import type { Client } from '../clients/client.ts';
import type { Core } from '../areas/core.ts';
import type { LimitName } from '../limits/index.ts';
import { RESOURCE, type Resource } from '../shares/resources.ts';
import type { Session } from '../sessions/session.ts';

/** Dependencies of the present uses. */
export type LimitUseContext = Pick<Core, 'topics' | 'patternTable' | 'selectionTable'> &
  Pick<Core, 'accounts' | 'clients' | 'devices' | 'sockets' | 'connections' | 'bodies'> &
  Pick<Core, 'access' | 'nodes' | 'sessions' | 'modules' | 'sessionLibrary'>;

/** Current usage of each limit that is measured. [EX-36] */
type LimitUses = { readonly [L in LimitName]?: (core: LimitUseContext) => Init<LimitUse> };

/** The present use of limits. Limits of one message, and times, have none. */
export const LIMIT_USES: LimitUses = {
  topics: ({ topics }) => ({ value: topics.size }),
  topicsPerClient: ofAccounts(RESOURCE.topics),
  topicsPerSession: ofSessions(({ modules }) =>
    modules.reduce((sum, { statistics }) => sum + (statistics?.topics ?? 0), 0),
  ),
  topicsPerModule: ofSessions(({ modules }) =>
    modules.reduce((most, { statistics }) => Math.max(most, statistics?.topics ?? 0), 0),
  ),
  retainedBytes: ({ topics }) => ({ value: topics.retainedBytes }),
  retainedBytesPerClient: ofAccounts(RESOURCE.retainedBytes),
  clients: ({ clients }) => ({ value: clients.size }),
  sockets: ({ sockets }) => ({ value: sockets.openCount }),
  connections: ({ connections }) => ({ value: connections.size }),
  connectionsOfStrangers: ({ connections }) => ({ value: connections.strangers }),
  connectionsPerAddress: ({ connections }) => ({ value: connections.mostOfAddress }),
  connectionsPerNetwork: ({ connections }) => ({ value: connections.mostOfNetwork }),
  grants: ({ access }) => ({ value: access.grants.size }),
  devices: ({ devices }) => ({ value: devices.size }),
  devicesPerClient: ofClients(({ devices }) => devices.size),
  componentsPerDevice: ofClients(({ devices }) =>
    [...devices.values()].reduce((most, device) => Math.max(most, device.components.length), 0),
  ),
  registrationBytesPerClient: ofAccounts(RESOURCE.registrationBytes),
  registrationBytes: ({ accounts }) => ({ value: accounts.all.used(RESOURCE.registrationBytes) }),

  subscriptions: ({ accounts }) => ({ value: accounts.all.used(RESOURCE.subscriptions) }),
  subscriptionsPerClient: ofClients(({ subscriber }) => subscriber.topics.size),
  patternsPerClient: ofClients(({ subscriber }) => subscriber.patterns.size),
  patterns: ({ patternTable }) => ({ value: patternTable.size }),
  profilesPerClient: ofClients(({ subscriber }) => subscriber.selections.size),
  profiles: ({ selectionTable }) => ({ value: selectionTable.size }),

  recordsPerSecond: ofClients(({ traffic }) => traffic.rates.recordsInPerSecond),
  publishedBytesPerSecond: ofClients(({ traffic }) => traffic.rates.bytesInPerSecond),

  connectionQueuedBytes: ofClients(({ socket }) => socket?.connection.queuedBytes ?? 0),
  queuesBytes: ({ accounts }) => ({ value: accounts.all.used(RESOURCE.queueBytes) }),
  queueBytes: ofClients(({ subscriber }) => subscriber.outbox.waitingBytes),

  bodyBytes: ({ bodies }) => ({ value: bodies.totalBytes }),
  bodyBytesOfStrangers: ({ bodies }) => ({ value: bodies.bytesOf('bodyBytesOfStrangers') }),
  bodyBytesOfJoining: ({ bodies }) => ({ value: bodies.bytesOf('bodyBytesOfJoining') }),
  bodyBytesPerAddress: ({ bodies }) => ({ value: bodies.mostOf('bodyBytesPerAddress') }),
  bodyBytesPerClient: ({ bodies }) => ({ value: bodies.mostOf('bodyBytesPerClient') }),
  bodyBytesPerConnection: ({ bodies }) => ({ value: bodies.mostOf('bodyBytesPerConnection') }),

  sessions: ({ sessions }) => ({ value: sessions.list().length }),
  modulesPerSession: ofSessions(({ modules }) => modules.length),
  mappingsPerSession: ofSessions(({ modules }) =>
    modules.reduce(
      (sum, { mapping }) => sum + mapping.inputMappings.length + mapping.outputMappings.length,
      0,
    ),
  ),
  moduleSourceBytes: ofSessions(({ modules }) =>
    modules.reduce((most, { spec }) => Math.max(most, spec.onProcessingStringified.length), 0),
  ),
  moduleBytes: ({ nodes, sessions }) => ({
    value: sessions.memoryOn(nodes.masterId),
  }),
  moduleBytesPerSession: ({ nodes, sessions }) => {
    const [which, value] = most(sessions.list(), (session) => session.memoryOn(nodes.masterId));
    return { value, sessionId: which?.id ?? '' };
  },
  sessionBytes: ofSessions(({ byteLength }) => byteLength),
  sessionsBytes: ({ sessions }) => ({
    value: sessions.list().reduce((sum, { byteLength }) => sum + byteLength, 0),
  }),
  storedDocuments: ({ modules, sessionLibrary }) => ({
    value: Math.max(modules.stored.list().size, sessionLibrary.stored.list().size),
  }),
  storedBytes: ({ modules, sessionLibrary }) => ({
    value: Math.max(modules.stored.byteLength, sessionLibrary.stored.byteLength),
  }),
};

/** The client that uses most of a scarce resource. */
function ofAccounts(resource: Resource): (core: LimitUseContext) => Init<LimitUse> {
  return ofClients(({ account }) => account.used(resource));
}

/** The client that uses most of what each may have. */
function ofClients(use: (client: Client) => number): (core: LimitUseContext) => Init<LimitUse> {
  return ({ clients }) => {
    const [who, value] = most(clients.values(), use);
    return { value, clientId: who?.id ?? '' };
  };
}

/** The session that uses most of what each may have. */
function ofSessions(use: (session: Session) => number): (core: LimitUseContext) => Init<LimitUse> {
  return ({ sessions }) => {
    const [which, value] = most(sessions.list(), use);
    return { value, sessionId: which?.id ?? '' };
  };
}

function most<T>(all: Iterable<T>, use: (one: T) => number): [T | undefined, number] {
  let found: T | undefined;
  let largest = 0;
  for (const one of all) {
    const value = use(one);
    if (value <= largest) continue;
    found = one;
    largest = value;
  }
  return [found, largest];
}
