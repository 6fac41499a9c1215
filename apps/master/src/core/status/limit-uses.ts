import type { Init, LimitUse } from '@ubii/proto';
import type { Client } from '../clients/client.ts';
import type { Core } from '../core.ts';
import type { LimitName } from '../limits.ts';
import type { Session } from '../sessions/session.ts';

/** How much of each limit is used, where that is known [EX-36]. */
type LimitUses = { readonly [L in LimitName]?: (core: Core) => Init<LimitUse> };

/** The present use of limits. Limits of one message, and times, have none. */
export const LIMIT_USES: LimitUses = {
  topics: ({ topics }) => ({ value: topics.size }),
  topicsPerClient: ofClients(({ ownedTopics }) => ownedTopics.size),
  retainedBytes: ({ topics }) => ({ value: topics.retainedBytes }),
  clients: ({ clients }) => ({ value: clients.size }),
  sockets: ({ sockets }) => ({ value: sockets.openCount }),
  grants: ({ access }) => ({ value: access.grants.size }),
  devicesPerClient: ofClients(({ devices }) => devices.size),
  componentsPerDevice: ofClients(({ devices }) =>
    [...devices.values()].reduce((most, device) => Math.max(most, device.components.length), 0),
  ),
  registrationBytesPerClient: ofClients(({ registrationBytes }) => registrationBytes),
  registrationBytes: ({ budget }) => ({ value: budget.totalBytes }),

  subscriptionsPerClient: ofClients(({ subscriber }) => subscriber.topics.size),
  patternsPerClient: ofClients(({ subscriber }) => subscriber.patterns.size),
  patterns: ({ patternTable }) => ({ value: patternTable.size }),
  profilesPerClient: ofClients(({ subscriber }) => subscriber.selections.size),
  profiles: ({ selectionTable }) => ({ value: selectionTable.size }),

  recordsPerSecond: ofClients(({ traffic }) => traffic.rates.recordsInPerSecond),
  publishedBytesPerSecond: ofClients(({ traffic }) => traffic.rates.bytesInPerSecond),

  connectionQueuedBytes: ofClients(({ socket }) => socket?.connection.queuedBytes ?? 0),
  queueBytes: ofClients(({ subscriber }) => subscriber.outbox.waitingBytes),

  sessions: ({ processing }) => ({ value: processing.sessions.list().length }),
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
  sessionBytes: ofSessions(({ byteLength }) => byteLength),
  sessionsBytes: ({ processing }) => ({
    value: processing.sessions.list().reduce((sum, { byteLength }) => sum + byteLength, 0),
  }),
  storedDocuments: ({ processing: { modules, sessionLibrary } }) => ({
    value: Math.max(modules.stored.list().size, sessionLibrary.stored.list().size),
  }),
  storedBytes: ({ processing: { modules, sessionLibrary } }) => ({
    value: Math.max(modules.stored.byteLength, sessionLibrary.stored.byteLength),
  }),
};

/** The client that uses most of what each may have. */
function ofClients(use: (client: Client) => number): (core: Core) => Init<LimitUse> {
  return ({ clients }) => {
    const [who, value] = most(clients.values(), use);
    return { value, clientId: who?.id ?? '' };
  };
}

/** The session that uses most of what each may have. */
function ofSessions(use: (session: Session) => number): (core: Core) => Init<LimitUse> {
  return ({ processing }) => {
    const [which, value] = most(processing.sessions.list(), use);
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
