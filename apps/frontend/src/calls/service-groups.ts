import { SERVICES, type ServiceName } from '@ubii/proto';

/** Services about one subject. */
export interface ServiceGroup {
  readonly title: string;
  /** What they are for, one sentence. */
  readonly sentence: string;
  readonly services: readonly ServiceName[];
}

/** Every service in its group, in the order of the page: the common ones first. */
export const SERVICE_GROUPS: readonly ServiceGroup[] = [
  {
    title: 'Topics',
    sentence: 'Subscribe, and see what is published and who receives it.',
    services: [
      'topicList',
      'topicSubscription',
      'topicStatistics',
      'topicSubscribers',
      'notifyConditionAdd',
      'notifyConditionRemove',
      'notifyConditionGetList',
    ],
  },
  {
    title: 'Clients',
    sentence: 'Join and leave, and see and limit what clients do.',
    services: [
      'clientGetList',
      'clientRegistration',
      'clientDeregistration',
      'clientReport',
      'clientRename',
      'clientDisconnect',
      'clientThrottle',
      'latencyClientsList',
    ],
  },
  {
    title: 'Devices',
    sentence: 'Devices of clients, and the components that they publish and receive.',
    services: [
      'deviceGetList',
      'deviceGet',
      'deviceRegistration',
      'deviceDeregistration',
      'componentGetList',
    ],
  },
  {
    title: 'Sessions',
    sentence: 'Create, start, stop and store sessions.',
    services: [
      'sessionRuntimeGetList',
      'sessionRuntimeGet',
      'sessionRuntimeAdd',
      'sessionRuntimeStart',
      'sessionPause',
      'sessionResume',
      'sessionRuntimeStop',
      'sessionRuntimeUpdate',
      'sessionRuntimeRemove',
      'sessionDatabaseGetList',
      'sessionDatabaseGet',
      'sessionDatabaseSave',
      'sessionDatabaseDelete',
      'sessionDatabaseLocalGetList',
      'sessionDatabaseOnlineGetList',
    ],
  },
  {
    title: 'Modules',
    sentence: 'The library of processing modules, and the nodes that run them.',
    services: [
      'processingModuleDatabaseGetList',
      'processingModuleDatabaseGet',
      'processingModuleDatabaseSave',
      'processingModuleDatabaseDelete',
      'processingModuleDatabaseLocalGetList',
      'processingModuleDatabaseOnlineGetList',
      'moduleVersionList',
      'processingModuleRuntimeGetList',
      'processingModuleRuntimeGet',
      'processingModuleRuntimeAdd',
      'processingModuleRuntimeRemove',
      'processingModuleRegistryAdd',
      'processingModuleRegistryRemove',
      'nodeList',
    ],
  },
  {
    title: 'Multiplexers and demultiplexers',
    sentence: 'Many topics as one input of a session, and one output as many topics.',
    services: [
      'topicMuxRuntimeGetList',
      'topicMuxRuntimeGet',
      'topicMuxDatabaseGetList',
      'topicMuxDatabaseGet',
      'topicMuxDatabaseSave',
      'topicMuxDatabaseDelete',
      'topicDemuxRuntimeGetList',
      'topicDemuxRuntimeGet',
      'topicDemuxDatabaseGetList',
      'topicDemuxDatabaseGet',
      'topicDemuxDatabaseSave',
      'topicDemuxDatabaseDelete',
    ],
  },
  {
    title: 'Recordings',
    sentence: 'Record topics, keep the last minutes, and play recordings.',
    services: [
      'recordingList',
      'recordingGet',
      'recordingStart',
      'recordingStop',
      'recordingChange',
      'recordingDelete',
      'recordingUpload',
      'recordingMark',
      'recordingEstimate',
      'flightRecorderGet',
      'flightRecorderSet',
      'flightRecorderRecords',
      'flightRecorderKeep',
      'replayList',
      'replayStart',
      'replayChange',
      'replayStop',
      'personalDataGet',
      'personalDataSet',
    ],
  },
  {
    title: 'Studies',
    sentence: 'Studies with their participants and runs.',
    services: [
      'studyList',
      'studyGet',
      'studySave',
      'studyDelete',
      'studyCheck',
      'studyRunStart',
      'studyRunChange',
      'studyRunGet',
      'studyRunList',
      'studyParticipantList',
      'studyParticipantDelete',
    ],
  },
  {
    title: 'Bridges',
    sentence: 'Mappings of bridges to other systems.',
    services: ['bridgeMappingsGet', 'bridgeMappingsCheck', 'bridgeMappingsSet'],
  },
  {
    title: 'Access',
    sentence: 'Invitations, and a log of what people did.',
    services: [
      'joinCheck',
      'accessGrantCreate',
      'accessGrantList',
      'accessGrantRevoke',
      'auditLog',
    ],
  },
  {
    title: 'Master',
    sentence: 'The master itself: status, limits, settings, log and models.',
    services: [
      'serverConfiguration',
      'serviceList',
      'masterStatus',
      'masterProof',
      'limitList',
      'settingList',
      'logTail',
      'lanOpen',
      'assetSetList',
      'assetSetDownload',
      'assetSetCancel',
    ],
  },
];

/** Topic of a service without the prefix that all have. */
export const shortTopicOf = (name: ServiceName): string =>
  SERVICES[name].topic.replace('/services/', '');

/** Returns the groups with the services in which all words of the search are found. */
export function findServices(search: string): readonly ServiceGroup[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  return SERVICE_GROUPS.flatMap((group) => {
    const services = group.services.filter((name) => {
      const { topic, description } = SERVICES[name];
      const text = `${name} ${topic} ${description} ${group.title}`.toLowerCase();
      return words.every((word) => text.includes(word));
    });
    return services.length > 0 ? [{ ...group, services }] : [];
  });
}
