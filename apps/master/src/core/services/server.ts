import { LEGACY_CONSTANTS, type Init, type Service, type ServiceInfo } from '@ubii/proto';
import { nameOf } from '../parts/settings.ts';
import { readMasterStatus } from '../monitoring/master-status.ts';
import type { ServiceHandler } from './handler.ts';

const CONSTANTS_JSON = JSON.stringify(LEGACY_CONSTANTS);

/** `/services/server_configuration` [SV-10] */
export const describeServer: ServiceHandler = ({ id, settings }, _request, { caller }) => {
  const endpoints = settings.endpoints();
  const { portServices, portTopicData } = endpoints;
  // A stranger knows the address it has come to, and is told of no other network. [AC-5]
  const isStranger = caller.role === 'none';
  const { ipEthernet, ipWlan } = isStranger ? { ipEthernet: '', ipWlan: '' } : endpoints;
  const host = ipEthernet || ipWlan;
  const external = (rest: string): string => (host === '' ? '' : `${host}:${rest}`);
  return {
    server: {
      id,
      name: nameOf(settings),
      ipEthernet,
      ipWlan,
      // There is no ZeroMQ here, but existing clients parse every port as a number.
      portServiceZmq: '0',
      portServiceRest: String(portServices),
      portTopicDataZmq: '0',
      portTopicDataWs: String(portTopicData),
      constantsJson: CONSTANTS_JSON,
      externalAddressServiceZmq: '',
      externalAddressServiceHttpJson: external(`${portServices}/services/json`),
      externalAddressServiceHttpBinary: external(`${portServices}/services/binary`),
      externalAddressTopicDataZmq: '',
      externalAddressTopicDataWs: external(`${portTopicData}`),
    },
  };
};

/** `/services/ubii/master_status` [EX-16] */
export const masterStatus: ServiceHandler = (core, request) => ({
  masterStatus: readMasterStatus(core, request.masterStatusRequest!.sinceMs),
});

/** `/services/ubii/setting_list` [EX-50] */
export const listSettings: ServiceHandler = ({ settings }) => ({
  settingList: { elements: [], ...settings.startedWith },
});

/**
 * `/services/service_list` [SV-9]
 * @param services The services that are answered.
 */
export function listServices(services: readonly ServiceInfo[]): ServiceHandler {
  const elements = services.map((service): Init<Service> => ({
    topic: service.topic,
    requestMessageFormat: service.requestFormat,
    responseMessageFormat: service.replyFormat,
    tags: [],
    description: service.description,
  }));
  return () => ({ serviceList: { elements } });
}
