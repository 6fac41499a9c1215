import type { ServiceName } from '@ubii/proto';
import type { GivenRole } from './roles.ts';

/** Who may call a service. `anyone` includes strangers. */
export interface ServiceRight {
  readonly roles: readonly GivenRole[] | 'anyone';
  /** Its request names the client that asks, which has to be the caller [AC-22]. */
  readonly actsForClient: boolean;
}

const ANYONE: ServiceRight = { roles: 'anyone', actsForClient: false };
const JOINED = right('admin', 'participant', 'player', 'viewer');
const READERS = right('admin', 'participant', 'viewer');
const PARTICIPANTS = right('admin', 'participant');
const ADMINS = right('admin');

/** Every service of the protocol and of ours: who may call it [AC-21]. */
export const SERVICE_RIGHTS: { readonly [S in ServiceName]: ServiceRight } = {
  serverConfiguration: ANYONE,
  joinCheck: ANYONE,
  // It says itself whom it lets in, and as whom. [AC-13] [AC-23]
  clientRegistration: ANYONE,

  clientDeregistration: actsForClient(JOINED),
  topicSubscription: actsForClient(JOINED),
  serviceList: JOINED,

  deviceRegistration: actsForClient(right('admin', 'participant', 'player')),
  deviceDeregistration: actsForClient(right('admin', 'participant', 'player')),

  topicList: READERS,
  topicStatistics: READERS,
  latencyClientsList: READERS,
  clientGetList: READERS,
  clientReport: READERS,
  deviceGet: READERS,
  deviceGetList: READERS,
  componentGetList: READERS,
  masterStatus: READERS,
  limitList: READERS,
  nodeList: READERS,
  moduleVersionList: READERS,
  notifyConditionGetList: READERS,
  processingModuleDatabaseGet: READERS,
  processingModuleDatabaseGetList: READERS,
  processingModuleDatabaseOnlineGetList: READERS,
  processingModuleDatabaseLocalGetList: READERS,
  processingModuleRuntimeGet: READERS,
  processingModuleRuntimeGetList: READERS,
  sessionDatabaseGet: READERS,
  sessionDatabaseGetList: READERS,
  sessionDatabaseOnlineGetList: READERS,
  sessionDatabaseLocalGetList: READERS,
  sessionRuntimeGet: READERS,
  sessionRuntimeGetList: READERS,
  topicDemuxDatabaseGet: READERS,
  topicDemuxDatabaseGetList: READERS,
  topicDemuxRuntimeGet: READERS,
  topicDemuxRuntimeGetList: READERS,
  topicMuxDatabaseGet: READERS,
  topicMuxDatabaseGetList: READERS,
  topicMuxRuntimeGet: READERS,
  topicMuxRuntimeGetList: READERS,

  notifyConditionAdd: PARTICIPANTS,
  notifyConditionRemove: PARTICIPANTS,
  processingModuleDatabaseSave: PARTICIPANTS,
  processingModuleDatabaseDelete: PARTICIPANTS,
  processingModuleRuntimeAdd: PARTICIPANTS,
  processingModuleRuntimeRemove: PARTICIPANTS,
  processingModuleRegistryAdd: PARTICIPANTS,
  processingModuleRegistryRemove: PARTICIPANTS,
  sessionDatabaseSave: PARTICIPANTS,
  sessionDatabaseDelete: PARTICIPANTS,
  sessionRuntimeAdd: PARTICIPANTS,
  sessionRuntimeRemove: PARTICIPANTS,
  sessionRuntimeStart: PARTICIPANTS,
  sessionRuntimeStop: PARTICIPANTS,
  sessionRuntimeUpdate: PARTICIPANTS,
  sessionPause: PARTICIPANTS,
  sessionResume: PARTICIPANTS,
  topicDemuxDatabaseSave: PARTICIPANTS,
  topicDemuxDatabaseDelete: PARTICIPANTS,
  topicMuxDatabaseSave: PARTICIPANTS,
  topicMuxDatabaseDelete: PARTICIPANTS,

  // Of others, only an admin's: see `requireTarget`.
  clientRename: actsForClient(PARTICIPANTS),
  clientDisconnect: actsForClient(PARTICIPANTS),
  // Or who is throttled would lift it.
  clientThrottle: actsForClient(ADMINS),

  logTail: ADMINS,
  settingList: ADMINS,
  accessGrantCreate: actsForClient(ADMINS),
  accessGrantList: ADMINS,
  accessGrantRevoke: actsForClient(ADMINS),
};

function right(...roles: readonly GivenRole[]): ServiceRight {
  return { roles, actsForClient: false };
}

function actsForClient({ roles }: ServiceRight): ServiceRight {
  return { roles, actsForClient: true };
}
