import type { ServiceName } from '@ubii/proto';
import type { GivenRole } from './roles.ts';

/** Who may call a service. `anyone` includes strangers. */
export interface ServiceRight {
  readonly roles: readonly GivenRole[] | 'anyone';
  /** Its request names the client that asks, which has to be the caller [AC-22]. */
  readonly actsForClient: boolean;
  /** The service affects other clients, so that its calls are audited [EX-90]. */
  readonly audited: boolean;
}

const ANYONE: ServiceRight = { roles: 'anyone', actsForClient: false, audited: false };
const JOINED = right('admin', 'participant', 'player', 'viewer');
const READERS = right('admin', 'participant', 'viewer');
const PARTICIPANTS = right('admin', 'participant');
const AUDITED_PARTICIPANTS = audited(PARTICIPANTS);
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
  // Players learn how many receive their own topics, and no names. [EX-96]
  topicSubscribers: JOINED,

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
  assetSetList: READERS,
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

  notifyConditionAdd: AUDITED_PARTICIPANTS,
  notifyConditionRemove: AUDITED_PARTICIPANTS,
  processingModuleDatabaseSave: AUDITED_PARTICIPANTS,
  processingModuleDatabaseDelete: AUDITED_PARTICIPANTS,
  processingModuleRuntimeAdd: PARTICIPANTS,
  processingModuleRuntimeRemove: PARTICIPANTS,
  processingModuleRegistryAdd: AUDITED_PARTICIPANTS,
  processingModuleRegistryRemove: AUDITED_PARTICIPANTS,
  sessionDatabaseSave: AUDITED_PARTICIPANTS,
  sessionDatabaseDelete: AUDITED_PARTICIPANTS,
  sessionRuntimeAdd: AUDITED_PARTICIPANTS,
  sessionRuntimeRemove: AUDITED_PARTICIPANTS,
  sessionRuntimeStart: AUDITED_PARTICIPANTS,
  sessionRuntimeStop: AUDITED_PARTICIPANTS,
  sessionRuntimeUpdate: AUDITED_PARTICIPANTS,
  sessionPause: AUDITED_PARTICIPANTS,
  sessionResume: AUDITED_PARTICIPANTS,
  topicDemuxDatabaseSave: AUDITED_PARTICIPANTS,
  topicDemuxDatabaseDelete: AUDITED_PARTICIPANTS,
  topicMuxDatabaseSave: AUDITED_PARTICIPANTS,
  topicMuxDatabaseDelete: AUDITED_PARTICIPANTS,

  // Of others, only an admin's: see `requireTarget`.
  clientRename: audited(actsForClient(PARTICIPANTS)),
  clientDisconnect: audited(actsForClient(PARTICIPANTS)),
  // Or who is throttled would lift it.
  clientThrottle: audited(actsForClient(ADMINS)),

  logTail: ADMINS,
  settingList: ADMINS,
  // On the machine of the master alone. [AC-47]
  lanOpen: audited(ADMINS),
  // The master connects to the publisher, and writes to its disk. [EX-58]
  assetSetDownload: audited(ADMINS),
  assetSetCancel: audited(ADMINS),
  accessGrantCreate: audited(actsForClient(ADMINS)),
  accessGrantList: ADMINS,
  auditLog: ADMINS,
  accessGrantRevoke: audited(actsForClient(ADMINS)),
};

function right(...roles: readonly GivenRole[]): ServiceRight {
  return { roles, actsForClient: false, audited: false };
}

function actsForClient({ roles }: ServiceRight): ServiceRight {
  return { roles, actsForClient: true, audited: false };
}

function audited(plain: ServiceRight): ServiceRight {
  return { ...plain, audited: true };
}
