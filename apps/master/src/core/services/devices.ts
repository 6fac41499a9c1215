import { selectByProfiles, ServiceError } from '@ubii/proto';
import { PUBLISHERS, READERS } from '../access/roles.ts';
import { quote } from '../texts/quote.ts';
import { definer, success } from './define-service.ts';
import { requireProfiles } from './list-limits.ts';
import { replayAfterReply, type AfterReplyContext } from './replay-after-reply.ts';

const define = definer<keyof AfterReplyContext | 'clients' | 'devices' | 'info' | 'limitWatch'>();

/** Services on devices and their components. */
export const DEVICE_SERVICES = [
  // [DV-1]
  define('deviceRegistration', {
    roles: PUBLISHERS,
    subject: ({ clientId }) => clientId,
    handle(core, message, call) {
      const client = core.clients.require(message.clientId, 'device.client_id');
      const { device, replays } = core.devices.register(client, message);
      core.info.announceClient(client); // [CL-31]
      replayAfterReply(core, call, client, replays); // [DV-3]
      return device;
    },
  }),
  // [DV-4]
  define('deviceDeregistration', {
    roles: PUBLISHERS,
    subject: ({ clientId }) => clientId,
    handle({ clients, devices, info }, { id, clientId }) {
      const client = clients.require(clientId, 'device.client_id');
      if (devices.deregister(client, id)) info.announceClient(client); // [CL-31]
      return success('The device is deregistered.');
    },
  }),
  // Clients that ask for a device of their own name themselves: activity. [CL-11]
  define('deviceGet', {
    roles: READERS,
    subject: ({ clientId }) => clientId,
    mayNameOthers: true,
    handle({ devices }, { id }) {
      const device = devices.get(id);
      if (device !== undefined) return device;
      throw id === ''
        ? new ServiceError(
            'invalid_argument',
            'The request has no device.id. Set it to the id of the device.',
          )
        : new ServiceError('not_found', `No registered device has the id ${quote(id)}.`);
    },
  }),
  // [CL-20] [CL-22]
  define('deviceGetList', {
    roles: READERS,
    handle(core, list) {
      const profiles = requireProfiles(core, list?.elements ?? []);
      return { elements: selectByProfiles(core.devices.list(), profiles) };
    },
  }),
  // [CL-20] [CL-22]
  define('componentGetList', {
    roles: READERS,
    handle(core, { component, componentList }) {
      const single = component === undefined ? [] : [component]; // [CL-21]
      const profiles = requireProfiles(core, componentList?.elements ?? single);
      const components = core.devices.list().flatMap((device) => device.components);
      return { elements: selectByProfiles(components, profiles) };
    },
  }),
];
