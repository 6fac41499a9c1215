import {
  ComponentIOType,
  type Client as ClientMessage,
  type Component,
  type Device,
} from '@ubii/proto';
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
  const { access, publishRights } = client;
  if (publishRights === undefined) return;
  if (access.role === 'viewer') {
    throw roleRefusal('Devices are for admins, participants and players; this client is a viewer.');
  }
  for (const component of device.components) {
    if (hasComponentRights(client, component)) continue;
    const verb = component.ioType === ComponentIOType.SUBSCRIBER ? 'subscribe' : 'publish';
    throw roleRefusal(
      `The device has a component on ${quote(component.topic)}, where this client may not ${verb}; its own topics begin with /${client.id}/.`,
    );
  }
}

/** Whether a device of this client may have the component. [AC-26] */
export function hasComponentRights(
  { publishRights, subscriber }: Pick<RightsHolder, 'publishRights' | 'subscriber'>,
  { topic, ioType }: Pick<Component, 'topic' | 'ioType'>,
): boolean {
  if (publishRights === undefined || topic === '') return true;
  return ioType === ComponentIOType.SUBSCRIBER
    ? subscriber.readRights?.mayRead(topic) !== false
    : publishRights.mayPublish(topic);
}

/** @throws ServiceError when a client of this role may not run or offer modules, as this one does [AC-26] */
export function requireNodeRights(role: Role, message: ClientMessage): void {
  if (role === 'admin' || role === 'participant') return;
  const { extension, processingModules, isDedicatedProcessingNode } = message;
  const isNode = extension?.node !== undefined || isDedicatedProcessingNode;
  if (!isNode && processingModules.length === 0) return;
  throw roleRefusal(`Nodes and modules are for admins and participants; this client is a ${role}.`);
}
