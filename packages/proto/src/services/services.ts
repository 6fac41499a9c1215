import type { ServiceReply, ServiceRequest } from '../generated/messages.ts';
import { ACCESS_SERVICES } from './access-services.ts';
import { BRIDGE_SERVICES } from './bridge-services.ts';
import { withoutPayload, withOptionalPayload, withPayload } from './define-service.ts';
import { OPERATION_SERVICES } from './operation-services.ts';
import { PROCESSING_MODULE_SERVICES } from './processing-module-services.ts';
import { RECORDING_SERVICES, REPLAY_SERVICES } from './recording-services.ts';
import { SESSION_SERVICES } from './session-services.ts';
import { STUDY_SERVICES } from './study-services.ts';
import { TOPIC_MAPPING_SERVICES } from './topic-mapping-services.ts';

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
  masterProof: withPayload(
    '/services/ubii/master_proof',
    'masterProofRequest',
    'masterProof',
    'Proves to a client that the master is of its cluster.',
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
    'Deregisters a client and removes its devices, subscriptions and topics.',
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
  notifyConditionAdd: withPayload(
    '/services/notify_condition/add',
    'notifyCondition',
    'notifyCondition',
    'Adds a condition for the receivers of a record, and returns its id.',
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
  topicSubscribers: withPayload(
    '/services/ubii/topic_subscribers',
    'topicSubscribersRequest',
    'topicSubscribersList',
    'Returns the receivers of topics: clients, and modules with their sessions.',
  ),
  masterStatus: withPayload(
    '/services/ubii/master_status',
    'masterStatusRequest',
    'masterStatus',
    'Returns the status of the master: counters, events, problems and addresses.',
  ),
  nodeList: withoutPayload(
    '/services/ubii/node_list',
    'nodeList',
    'Lists the nodes that can run processing modules, the master first.',
  ),
  sessionPause: withPayload(
    '/services/ubii/session_pause',
    'session',
    'session',
    'Pauses the running session with the given id; its modules keep their state.',
  ),
  sessionResume: withPayload(
    '/services/ubii/session_resume',
    'session',
    'session',
    'Resumes the paused session with the given id.',
  ),
  ...OPERATION_SERVICES,
  ...ACCESS_SERVICES,
  ...PROCESSING_MODULE_SERVICES,
  ...RECORDING_SERVICES,
  ...REPLAY_SERVICES,
  ...STUDY_SERVICES,
  ...BRIDGE_SERVICES,
  ...SESSION_SERVICES,
  ...TOPIC_MAPPING_SERVICES,
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

/** Reply of a service on success. */
export type ServiceReplyOf<S extends ServiceName> = NonNullable<ServiceReply[Table[S]['reply']]>;

const NAME_BY_TOPIC: ReadonlyMap<string, ServiceName> = new Map(
  (Object.keys(SERVICES) as ServiceName[]).map((name) => [SERVICES[name].topic, name]),
);

/** The service that is called on a topic. */
export function serviceByTopic(topic: string): ServiceName | undefined {
  return NAME_BY_TOPIC.get(topic);
}
