import { LEGACY_CONSTANTS } from '@ubii/proto';
import { ADMINS } from '../access/roles.ts';
import { nameOf } from '../areas/settings.ts';
import { definer } from './define-service.ts';
import { lanOpen } from './lan.ts';
import { masterProof } from './master-proof.ts';

const define = definer<'id' | 'settings'>();

const CONSTANTS_JSON = JSON.stringify(LEGACY_CONSTANTS);

/** Services on the master itself: where it is, and what it was started with. */
export const SERVER_SERVICES = [
  // [SV-10]
  define('serverConfiguration', {
    roles: 'anyone',
    handle({ id, settings }, _payload, { caller }) {
      const endpoints = settings.endpoints();
      const { portServices, portTopicData, portServicesZmq, portTopicDataZmq } = endpoints;
      // A stranger knows the address it has come to, and is told of no other network. [AC-5]
      const isStranger = caller.role === 'none';
      const { ipEthernet, ipWlan } = isStranger ? { ipEthernet: '', ipWlan: '' } : endpoints;
      const host = ipEthernet || ipWlan;
      const external = (rest: string): string => (host === '' ? '' : `${host}:${rest}`);
      const externalZmq = (port: number): string => (port === 0 ? '' : external(`${port}`));
      return {
        id,
        name: nameOf(settings),
        ipEthernet,
        ipWlan,
        // Without ZeroMQ, they are 0: existing clients parse every port as a number.
        portServiceZmq: String(portServicesZmq),
        portServiceRest: String(portServices),
        portTopicDataZmq: String(portTopicDataZmq),
        portTopicDataWs: String(portTopicData),
        constantsJson: CONSTANTS_JSON,
        externalAddressServiceZmq: externalZmq(portServicesZmq),
        externalAddressServiceHttpJson: external(`${portServices}/services/json`),
        externalAddressServiceHttpBinary: external(`${portServices}/services/binary`),
        externalAddressTopicDataZmq: externalZmq(portTopicDataZmq),
        externalAddressTopicDataWs: external(`${portTopicData}`),
      };
    },
  }),
  // [EX-50]
  define('settingList', {
    roles: ADMINS,
    handle: ({ settings }) => ({ elements: [], ...settings.startedWith }),
  }),
  lanOpen,
  masterProof,
];
