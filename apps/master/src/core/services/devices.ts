import { ServiceError } from '@ubii/proto';
import { selectByProfiles } from '../topics/profiles.ts';
import { quote } from '../texts/quote.ts';
import type { ServiceHandler } from './handler.ts';
import { requireProfiles } from './list-limits.ts';
import { replayAfterReply } from './replay-after-reply.ts';

/** `/services/device/registration` [DV-1] */
export const registerDevice: ServiceHandler = (core, request, call) => {
  const message = request.device!;
  const client = core.clients.require(message.clientId, 'device.client_id');
  const { device, owed } = core.devices.register(client, message);
  core.info.announceClient(client); // [CL-31]
  replayAfterReply(core, call, client, owed); // [DV-3]
  return { device };
};

/** `/services/device/deregistration` [DV-4] */
export const deregisterDevice: ServiceHandler = (core, request) => {
  const { id, clientId } = request.device!;
  const client = core.clients.require(clientId, 'device.client_id');
  if (core.devices.deregister(client, id)) core.info.announceClient(client); // [CL-31]
  return { success: { title: 'Success', message: 'The device is deregistered.' } };
};

/** `/services/device/get` */
export const getDevice: ServiceHandler = (core, request) => {
  const { id } = request.device!;
  const device = core.devices.get(id);
  if (device !== undefined) return { device };
  throw id === ''
    ? new ServiceError(
        'invalid_argument',
        'The request has no device.id. Set it to the id of the device.',
      )
    : new ServiceError('not_found', `No registered device has the id ${quote(id)}.`);
};

/** `/services/device/get_list` [CL-20] [CL-22] */
export const listDevices: ServiceHandler = (core, request) => {
  const profiles = requireProfiles(core, request.deviceList?.elements ?? []);
  return { deviceList: { elements: selectByProfiles(core.devices.list(), profiles) } };
};

/** `/services/component/get_list` [CL-20] [CL-22] */
export const listComponents: ServiceHandler = (core, request) => {
  const single = request.component === undefined ? [] : [request.component]; // [CL-21]
  const profiles = requireProfiles(core, request.componentList?.elements ?? single);
  const components = core.devices.list().flatMap((device) => device.components);
  return { componentList: { elements: selectByProfiles(components, profiles) } };
};
