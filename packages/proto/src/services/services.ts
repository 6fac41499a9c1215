import type { ServiceReply, ServiceRequest } from '../generated/messages.ts';
import { withoutPayload, withOptionalPayload, withPayload } from './define-service.ts';

/**
 * Every service of the protocol and of ours, one table for master, clients and user interface.
 * A master need not offer all of them: what it offers is in its service list. [SV-9]
 */
export const SERVICES = {
  serverConfiguration: withoutPayload(
    '/services/server_configuration',
    'server',
    'Describes the master: id, addresses, ports and constants.',
    { constant: 'SERVER_CONFIG' },
  ),
  serviceList: withoutPayload(
    '/services/service_list',
    'serviceList',
    'Lists every service the master offers.',
    { constant: 'SERVICE_LIST' },
  ),
  topicList: withoutPayload(
    '/services/topic_list',
    'stringList',
    'Lists the topics of the services and every topic that holds a value.',
    { constant: 'TOPIC_LIST' },
  ),
  topicSubscription: withPayload(
    '/services/topic_subscription',
    'topicSubscription',
    'success',
    'Subscribes a client to topics, patterns and components, and unsubscribes it.',
    { constant: 'TOPIC_SUBSCRIPTION' },
  ),
  latencyClientsList: withoutPayload(
    '/services/latency_clients_list',
    'clientList',
    'Lists the clients with their latency in milliseconds.',
    { constant: 'LATENCY_CLIENTS_LIST' },
  ),

  clientRegistration: withPayload(
    '/services/client/registration',
    'client',
    'client',
    'Registers a client and gives it an id.',
    { constant: 'CLIENT_REGISTRATION' },
  ),
  clientDeregistration: withPayload(
    '/services/client/deregistration',
    'client',
    'success',
    'Removes a client with its devices, subscriptions and topics.',
    { constant: 'CLIENT_DEREGISTRATION' },
  ),
  clientGetList: withOptionalPayload(
    '/services/client/get_list',
    'clientList',
    'clientList',
    'Lists the clients that match one of the given profiles, or all.',
    { constant: 'CLIENT_GET_LIST' },
  ),

  deviceRegistration: withPayload(
    '/services/device/registration',
    'device',
    'device',
    'Registers a device of a client and gives ids to it and to its components.',
    { constant: 'DEVICE_REGISTRATION' },
  ),
  deviceDeregistration: withPayload(
    '/services/device/deregistration',
    'device',
    'success',
    'Removes a device and the values of the topics it publishes.',
    { constant: 'DEVICE_DEREGISTRATION' },
  ),
  deviceGet: withPayload(
    '/services/device/get',
    'device',
    'device',
    'Returns the device with the given id.',
    { constant: 'DEVICE_GET' },
  ),
  deviceGetList: withOptionalPayload(
    '/services/device/get_list',
    'deviceList',
    'deviceList',
    'Lists the devices that match one of the given profiles, or all.',
    { constant: 'DEVICE_GET_LIST' },
  ),
  componentGetList: withOptionalPayload(
    '/services/component/get_list',
    'componentList',
    'componentList',
    'Lists the components that match one of the given profiles, or all.',
    { constant: 'COMPONENT_GET_LIST', alternativeRequest: 'component' },
  ),

  processingModuleDatabaseSave: withPayload(
    '/services/processing_module/database/save',
    'processingModule',
    'processingModule',
    'Stores a processing module.',
    { constant: 'PM_DATABASE_SAVE' },
  ),
  processingModuleDatabaseDelete: withPayload(
    '/services/processing_module/database/delete',
    'processingModule',
    'success',
    'Deletes a stored processing module.',
    { constant: 'PM_DATABASE_DELETE' },
  ),
  processingModuleDatabaseGet: withPayload(
    '/services/processing_module/database/get',
    'processingModule',
    'processingModuleList',
    'Returns the stored processing module of the given name, as a list of one.',
    { constant: 'PM_DATABASE_GET' },
  ),
  processingModuleDatabaseGetList: withOptionalPayload(
    '/services/processing_module/database/get_list',
    'processingModuleList',
    'processingModuleList',
    'Lists stored processing modules and those that clients offer.',
    { constant: 'PM_DATABASE_GET_LIST' },
  ),
  processingModuleDatabaseOnlineGetList: withOptionalPayload(
    '/services/processing_module/database/online/get_list',
    'processingModuleList',
    'processingModuleList',
    'Lists the processing modules of the online library.',
    { constant: 'PM_DATABASE_ONLINE_GET_LIST' },
  ),
  processingModuleDatabaseLocalGetList: withOptionalPayload(
    '/services/processing_module/database/local/get_list',
    'processingModuleList',
    'processingModuleList',
    'Lists the processing modules stored at the master.',
    { constant: 'PM_DATABASE_LOCAL_GET_LIST' },
  ),
  processingModuleRuntimeAdd: withPayload(
    '/services/processing_module/runtime/add',
    'processingModuleList',
    'success',
    'Tells the master that a node has started processing modules.',
    { constant: 'PM_RUNTIME_ADD' },
  ),
  processingModuleRuntimeRemove: withPayload(
    '/services/processing_module/runtime/remove',
    'processingModuleList',
    'success',
    'Tells the master that a node has stopped processing modules.',
    { constant: 'PM_RUNTIME_REMOVE' },
  ),
  processingModuleRuntimeGet: withPayload(
    '/services/processing_module/runtime/get',
    'processingModule',
    'processingModule',
    'Returns the running processing module with the given id.',
    { constant: 'PM_RUNTIME_GET' },
  ),
  processingModuleRuntimeGetList: withOptionalPayload(
    '/services/processing_module/runtime/get_list',
    'processingModuleList',
    'processingModuleList',
    'Lists the running processing modules.',
    { constant: 'PM_RUNTIME_GET_LIST' },
  ),
  processingModuleRegistryAdd: withPayload(
    '/services/processing_module/registry/add_list',
    'processingModuleList',
    'success',
    'Adds processing modules to those a client offers.',
    { constant: 'PM_REGISTRY_ADD' },
  ),
  processingModuleRegistryRemove: withPayload(
    '/services/processing_module/registry/remove_list',
    'processingModuleList',
    'success',
    'Removes processing modules from those a client offers.',
    { constant: 'PM_REGISTRY_REMOVE' },
  ),

  sessionDatabaseSave: withPayload(
    '/services/session/database/save',
    'session',
    'sessionList',
    'Stores sessions.',
    { constant: 'SESSION_DATABASE_SAVE', alternativeRequest: 'sessionList' },
  ),
  sessionDatabaseDelete: withPayload(
    '/services/session/database/delete',
    'session',
    'success',
    'Deletes the stored session with the given id.',
    { constant: 'SESSION_DATABASE_DELETE' },
  ),
  sessionDatabaseGet: withPayload(
    '/services/session/database/get',
    'session',
    'session',
    'Returns the stored session with the given id.',
    { constant: 'SESSION_DATABASE_GET' },
  ),
  sessionDatabaseGetList: withoutPayload(
    '/services/session/database/get_list',
    'sessionList',
    'Lists the stored sessions.',
    { constant: 'SESSION_DATABASE_GET_LIST' },
  ),
  sessionDatabaseOnlineGetList: withoutPayload(
    '/services/session/database/online/get_list',
    'sessionList',
    'Lists the sessions of the online library.',
    { constant: 'SESSION_DATABASE_ONLINE_GET_LIST' },
  ),
  sessionDatabaseLocalGetList: withoutPayload(
    '/services/session/database/local/get_list',
    'sessionList',
    'Lists the sessions stored at the master.',
    { constant: 'SESSION_DATABASE_LOCAL_GET_LIST' },
  ),
  sessionRuntimeAdd: withPayload(
    '/services/session/runtime/add',
    'session',
    'session',
    'Creates a session without starting it and gives it an id.',
    { constant: 'SESSION_RUNTIME_ADD' },
  ),
  sessionRuntimeRemove: withPayload(
    '/services/session/runtime/remove',
    'session',
    'success',
    'Removes a session; it is stopped first.',
    { constant: 'SESSION_RUNTIME_REMOVE' },
  ),
  sessionRuntimeGet: withPayload(
    '/services/session/runtime/get',
    'session',
    'session',
    'Returns the session with the given id.',
    { constant: 'SESSION_RUNTIME_GET' },
  ),
  sessionRuntimeGetList: withoutPayload(
    '/services/session/runtime/get_list',
    'sessionList',
    'Lists the sessions, stopped ones included.',
    { constant: 'SESSION_RUNTIME_GET_LIST' },
  ),
  sessionRuntimeStart: withPayload(
    '/services/session/runtime/start',
    'session',
    'session',
    'Starts a session: a known one by id or name, or the one given.',
    { constant: 'SESSION_RUNTIME_START' },
  ),
  sessionRuntimeStop: withPayload(
    '/services/session/runtime/stop',
    'session',
    'success',
    'Stops the session with the given id.',
    { constant: 'SESSION_RUNTIME_STOP' },
  ),
  sessionRuntimeUpdate: withPayload(
    '/services/session/runtime/update',
    'session',
    'session',
    'Replaces the specification of a session.',
    { constant: 'SESSION_RUNTIME_UPDATE' },
  ),

  topicDemuxDatabaseSave: withPayload(
    '/services/device/topic_demux/database/save',
    'topicDemux',
    'topicDemux',
    'Stores a demultiplexer.',
    { constant: 'TOPIC_DEMUX_DATABASE_SAVE' },
  ),
  topicDemuxDatabaseDelete: withPayload(
    '/services/device/topic_demux/database/delete',
    'topicDemux',
    'success',
    'Deletes a stored demultiplexer.',
    { constant: 'TOPIC_DEMUX_DATABASE_DELETE' },
  ),
  topicDemuxDatabaseGet: withPayload(
    '/services/device/topic_demux/database/get',
    'topicDemux',
    'topicDemux',
    'Returns the stored demultiplexer with the given id.',
    { constant: 'TOPIC_DEMUX_DATABASE_GET' },
  ),
  topicDemuxDatabaseGetList: withoutPayload(
    '/services/device/topic_demux/database/get_list',
    'topicDemuxList',
    'Lists the stored demultiplexers.',
    { constant: 'TOPIC_DEMUX_DATABASE_GET_LIST' },
  ),
  topicDemuxRuntimeGet: withPayload(
    '/services/device/topic_demux/runtime/get',
    'topicDemux',
    'topicDemux',
    'Returns the demultiplexer in use with the given id.',
    { constant: 'TOPIC_DEMUX_RUNTIME_GET' },
  ),
  topicDemuxRuntimeGetList: withoutPayload(
    '/services/device/topic_demux/runtime/get_list',
    'topicDemuxList',
    'Lists the demultiplexers in use.',
    { constant: 'TOPIC_DEMUX_RUNTIME_GET_LIST' },
  ),
  topicMuxDatabaseSave: withPayload(
    '/services/device/topic_mux/database/save',
    'topicMux',
    'topicMux',
    'Stores a multiplexer.',
    { constant: 'TOPIC_MUX_DATABASE_SAVE' },
  ),
  topicMuxDatabaseDelete: withPayload(
    '/services/device/topic_mux/database/delete',
    'topicMux',
    'success',
    'Deletes a stored multiplexer.',
    { constant: 'TOPIC_MUX_DATABASE_DELETE' },
  ),
  topicMuxDatabaseGet: withPayload(
    '/services/device/topic_mux/database/get',
    'topicMux',
    'topicMux',
    'Returns the stored multiplexer with the given id.',
    { constant: 'TOPIC_MUX_DATABASE_GET' },
  ),
  topicMuxDatabaseGetList: withoutPayload(
    '/services/device/topic_mux/database/get_list',
    'topicMuxList',
    'Lists the stored multiplexers.',
    { constant: 'TOPIC_MUX_DATABASE_GET_LIST' },
  ),
  topicMuxRuntimeGet: withPayload(
    '/services/device/topic_mux/runtime/get',
    'topicMux',
    'topicMux',
    'Returns the multiplexer in use with the given id.',
    { constant: 'TOPIC_MUX_RUNTIME_GET' },
  ),
  topicMuxRuntimeGetList: withoutPayload(
    '/services/device/topic_mux/runtime/get_list',
    'topicMuxList',
    'Lists the multiplexers in use.',
    { constant: 'TOPIC_MUX_RUNTIME_GET_LIST' },
  ),

  notifyConditionAdd: withPayload(
    '/services/notify_condition/add',
    'notifyCondition',
    'notifyCondition',
    'Adds a condition on who is told about a record, and gives it an id.',
  ),
  notifyConditionRemove: withPayload(
    '/services/notify_condition/remove',
    'notifyCondition',
    'success',
    'Removes the condition with the given id.',
  ),
  notifyConditionGetList: withoutPayload(
    '/services/notify_condition/get_list',
    'notifyCondition',
    'Returns the conditions; the protocol has no list of them, so only one fits the reply.',
  ),

  topicStatistics: withPayload(
    '/services/ubii/topic_statistics',
    'topicStatisticsRequest',
    'topicStatistics',
    'Returns the counters of the topics that changed since a cursor.',
  ),
  masterStatus: withPayload(
    '/services/ubii/master_status',
    'masterStatusRequest',
    'masterStatus',
    'Returns how the master is: counters, events, problems and addresses.',
  ),
} as const;

/** Name of a service in `SERVICES`. */
export type ServiceName = keyof typeof SERVICES;

type Table = typeof SERVICES;

/** The payload a service takes; undefined when it takes none. */
export type ServiceRequestOf<S extends ServiceName> = Table[S]['request'] extends infer Q
  ? Q extends keyof ServiceRequest
    ? NonNullable<ServiceRequest[Q]>
    : undefined
  : never;

/** What a service returns on success. */
export type ServiceReplyOf<S extends ServiceName> = NonNullable<ServiceReply[Table[S]['reply']]>;

const NAME_BY_TOPIC: ReadonlyMap<string, ServiceName> = new Map(
  (Object.keys(SERVICES) as ServiceName[]).map((name) => [SERVICES[name].topic, name]),
);

/** The service that is called on a topic. */
export function serviceByTopic(topic: string): ServiceName | undefined {
  return NAME_BY_TOPIC.get(topic);
}
