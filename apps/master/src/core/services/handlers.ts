import { SERVICES, type ServiceName } from '@ubii/proto';
import {
  controlThrottle,
  disconnectClient,
  renameClient,
  reportClients,
} from './client-control.ts';
import { checkJoin, createGrant, listGrants, revokeGrant } from './access.ts';
import { deregisterClient, listClients, listLatencies } from './clients.ts';
import {
  deregisterDevice,
  getDevice,
  listComponents,
  listDevices,
  registerDevice,
} from './devices.ts';
import { cancelAssetSet, downloadAssetSet, listAssetSets } from './asset-sets.ts';
import { readAuditLog } from './audit.ts';
import type { ServiceHandler } from './handler.ts';
import { openLan } from './lan.ts';
import { listLimits } from './limits.ts';
import { tailLog } from './log.ts';
import { listModuleVersions } from './module-versions.ts';
import { describeServer, listServices, listSettings, masterStatus } from './server.ts';
import {
  addRunningModules,
  deleteModule,
  getModule,
  getRunningModule,
  listLocalModules,
  listModules,
  listNodes,
  listOnlineModules,
  listRunningModules,
  removeRunningModules,
  saveModule,
} from './modules.ts';
import { registerClient } from './registration.ts';
import {
  deleteStoredSession,
  getStoredSession,
  listOnlineSessions,
  listStoredSessions,
  saveSessions,
} from './session-database.ts';
import {
  addSession,
  getSession,
  listSessions,
  pauseSession,
  removeSession,
  resumeSession,
  startSession,
  stopSession,
  updateSession,
} from './sessions.ts';
import { subscribe } from './topic-subscription.ts';
import { topicSubscribers } from './topic-subscribers.ts';
import { listTopics, topicStatistics } from './topics.ts';
import { whenRemembered } from './when-remembered.ts';

/** Who answers which service. */
const DOMAIN_HANDLERS = {
  serverConfiguration: describeServer,
  topicSubscription: subscribe,
  clientRegistration: registerClient,
  clientDeregistration: deregisterClient,
  clientGetList: listClients,
  latencyClientsList: listLatencies,
  deviceRegistration: registerDevice,
  deviceDeregistration: deregisterDevice,
  deviceGet: getDevice,
  deviceGetList: listDevices,
  componentGetList: listComponents,
  topicStatistics,
  topicSubscribers,
  masterStatus,
  nodeList: listNodes,
  clientReport: reportClients,
  clientRename: renameClient,
  clientDisconnect: disconnectClient,
  clientThrottle: controlThrottle,
  limitList: listLimits,
  settingList: listSettings,
  logTail: tailLog,
  lanOpen: openLan,
  assetSetList: listAssetSets,
  assetSetDownload: downloadAssetSet,
  assetSetCancel: cancelAssetSet,
  joinCheck: checkJoin,
  accessGrantCreate: createGrant,
  accessGrantList: listGrants,
  accessGrantRevoke: revokeGrant,
  auditLog: readAuditLog,
  moduleVersionList: listModuleVersions,
  sessionRuntimeAdd: addSession,
  sessionRuntimeGet: getSession,
  sessionRuntimeGetList: listSessions,
  sessionRuntimeStart: whenRemembered(startSession),
  sessionRuntimeStop: whenRemembered(stopSession),
  sessionRuntimeUpdate: whenRemembered(updateSession),
  sessionRuntimeRemove: whenRemembered(removeSession),
  sessionPause: pauseSession,
  sessionResume: resumeSession,
  sessionDatabaseSave: saveSessions,
  sessionDatabaseDelete: deleteStoredSession,
  sessionDatabaseGet: getStoredSession,
  sessionDatabaseGetList: listStoredSessions,
  sessionDatabaseLocalGetList: listStoredSessions,
  sessionDatabaseOnlineGetList: listOnlineSessions,
  processingModuleDatabaseSave: saveModule,
  processingModuleDatabaseDelete: deleteModule,
  processingModuleDatabaseGet: getModule,
  processingModuleDatabaseGetList: listModules,
  processingModuleDatabaseLocalGetList: listLocalModules,
  processingModuleDatabaseOnlineGetList: listOnlineModules,
  processingModuleRuntimeAdd: addRunningModules,
  processingModuleRuntimeRemove: removeRunningModules,
  processingModuleRuntimeGet: getRunningModule,
  processingModuleRuntimeGetList: listRunningModules,
} as const satisfies Partial<Record<ServiceName, ServiceHandler>>;

/** The services that are answered, these two lists of them included. */
const ANSWERED = [
  ...(Object.keys(DOMAIN_HANDLERS) as (keyof typeof DOMAIN_HANDLERS)[]),
  'serviceList',
  'topicList',
] as const;

/** Every service this master answers. The others of the protocol are `unimplemented`. */
export const HANDLERS: { readonly [S in ServiceName]?: ServiceHandler } = {
  ...DOMAIN_HANDLERS,
  serviceList: listServices(ANSWERED.map((name) => SERVICES[name])),
  topicList: listTopics(ANSWERED.map((name) => SERVICES[name].topic)),
};
