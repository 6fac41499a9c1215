import { ComponentIOType, type Client as ClientMessage, type Device } from '@ubii/proto';
import { quote } from '../texts/quote.ts';
import { roleRefusal } from './join-refusals.ts';
import type { PublishRights, ReadRights } from '../topics/rights.ts';
import type { ClientAccess } from './caller.ts';
import type { Role } from './roles.ts';

/** The client that registers a device, as its rights are asked for. */
interface RightsHolder {
  readonly id: string;
  readonly access: ClientAccess;
  readonly publishRights: PublishRights | undefined;
  readonly subscriber: { readonly readRights: ReadRights | undefined };
}

/** @throws ServiceError when this client may not register the device [AC-26] */
export function requireDeviceRights(client: RightsHolder, device: Device): void {
  const { access, publishRights, subscriber } = client;
  if (publishRights === undefined) return;
  if (access.role === 'viewer') {
    throw roleRefusal('Devices are for admins, participants and players; this client is a viewer.');
  }
  for (const { topic, ioType } of device.components) {
    if (topic === '') continue;
    const isInput = ioType === ComponentIOType.SUBSCRIBER;
    const may = isInput
      ? subscriber.readRights?.mayRead(topic) !== false
      : publishRights.mayPublish(topic);
    if (may) continue;
    throw roleRefusal(
      `The device has a component on ${quote(topic)}, where this client may not ${isInput ? 'subscribe' : 'publish'}; its own topics begin with /${client.id}/.`,
    );
  }
}

/** @throws ServiceError when a client of this role may not run or offer modules, as this one does [AC-26] */
export function requireNodeRights(role: Role, message: ClientMessage): void {
  if (role === 'admin' || role === 'participant') return;
  const { extension, processingModules, isDedicatedProcessingNode } = message;
  const isNode = extension?.node !== undefined || isDedicatedProcessingNode;
  if (!isNode && processingModules.length === 0) return;
  throw roleRefusal(`Nodes and modules are for admins and participants; this client is a ${role}.`);
}
