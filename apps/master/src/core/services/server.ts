import { ServiceError, masterHost, masterProofText, LEGACY_CONSTANTS } from '@ubii/proto';
import { ADMINS } from '../access/roles.ts';
import { definer, success } from './define-service.ts';
import { nameOf } from '../areas/settings.ts';

/** Opens the master to the local network, on the machine of the master alone. [AC-47] */
const lanOpen = definer<'lan' | 'log' | 'settings'>()('lanOpen', {
  roles: ADMINS,
  auditObject: () => '',
  async handle({ lan, log, settings }, _payload, { isHere }) {
    if (lan.isOpen) return success('The local network can reach this master.');
    if (!isHere) {
      throw new ServiceError(
        'failed_precondition',
        'The local network can be turned on only from the machine that runs the master. Open this page there.',
      );
    }
    try {
      await lan.open();
    } catch (cause) {
      const reason = cause instanceof Error ? cause.message : String(cause);
      throw new ServiceError(
        'unavailable',
        `The local network could not be turned on, and nothing has changed: ${reason}`,
      );
    }
    log.info('the local network can reach the master until it ends', {
      addresses: settings
        .endpoints()
        .addresses.map(({ url }) => url)
        .join(' '),
    });
    return success('The local network can reach this master until it ends.');
  },
});

/** Random and unique: long enough for that, and short enough to be signed for any caller. */
const NONCE = /^[!-~]{16,64}$/;

/**
 * Proves to a client that this master is of its cluster, before the client shows its token. [CU-85]
 *
 * A caller that used another address gets a proof of no address, as long as any other: it is worth nothing to a server that
 * passes the question on, and tells a stranger of no network. [AC-5]
 */
const masterProof = definer<'settings' | 'tokens'>()('masterProof', {
  roles: 'anyone',
  handle({ settings, tokens }, { targetId, host, nonce }) {
    if (!NONCE.test(nonce)) {
      throw new ServiceError(
        'invalid_argument',
        'Expected a nonce of 16 to 64 characters of ASCII without spaces.',
      );
    }
    const own = settings.endpoints().addresses.map(({ url }) => masterHost(url ?? ''));
    const proven = own.includes(host) ? host : '';
    const text = masterProofText({ host: proven, clientId: targetId, nonce });
    return { proof: tokens.prove(targetId, text) };
  },
});

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
      // A stranger knows the address that it used, and learns no other network. [AC-5]
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
