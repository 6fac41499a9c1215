import {
  ComponentIOType,
  DeviceType,
  encode,
  ServiceError,
  type Component,
  type Device,
} from '@ubii/proto';
import { areEqual } from '../topics/equal-bytes.ts';
import { requireDeviceRights } from '../access/device-rights.ts';
import type { InfoTopics } from '../info/info-topics.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { Accounts } from '../shares/accounts.ts';
import { RESOURCE } from '../shares/resources.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { quote } from '../texts/quote.ts';
import type { SubscriptionTable } from '../topics/subscription-table.ts';
import type { TopicEntry } from '../topics/topic-entry.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import type { DeviceOwner } from './device-owner.ts';
import { SharedTexts } from './shared-texts.ts';

/** Dependencies of a device registry. */
export interface DeviceContext {
  readonly ids: IdSource;
  readonly limits: LimitWatch;
  readonly topics: TopicTable;
  readonly subscriptions: SubscriptionTable;
  readonly info: InfoTopics;
  readonly accounts: Accounts;
}

interface Registered {
  readonly device: Device;
  readonly client: DeviceOwner;
  readonly byteLength: number;
}

const NO_COMPONENTS: readonly Component[] = [];

/** Every registered device with its components. */
export class DeviceRegistry {
  readonly #context: DeviceContext;
  readonly #devices = new Map<string, Registered>();
  readonly #componentIds = new Set<string>();
  readonly #texts = new SharedTexts();
  /** Components that publish, by topic; created on first use. */
  #byTopic: Map<string, Component[]> | undefined = undefined;
  /** Clients with a component that subscribes, by its topic; created on first use. */
  #inputsByTopic: Map<string, Set<string>> | undefined = undefined;

  constructor(context: DeviceContext) {
    this.#context = context;
  }

  get size(): number {
    return this.#devices.size;
  }

  get(id: string): Device | undefined {
    return this.#devices.get(id)?.device;
  }

  /** Devices of clients that are there [CL-22]. */
  list(): Device[] {
    return [...this.#devices.values()]
      .filter(({ client }) => client.status !== 'unavailable')
      .map(({ device }) => device);
  }

  /** Registered components that publish on this topic. */
  publishersOf(topic: string): readonly Component[] {
    return this.#publishers().get(topic) ?? NO_COMPONENTS;
  }

  /** Whether a component of this client subscribes to the topic: what others publish there is meant for it [AC-24]. */
  isInputOf(clientId: string, topic: string): boolean {
    return this.#inputs().get(topic)?.has(clientId) ?? false;
  }

  /** Id of the device that has a component which publishes on this topic. */
  deviceOfTopic(topic: string): string | undefined {
    return this.#publishers().get(topic)?.[0]?.deviceId;
  }

  /**
   * Registers a device of this client, or replaces it.
   * @returns the device with its ids, and the topics whose retained record a watcher receives.
   * @throws ServiceError when the id belongs to another client, or a limit would be exceeded.
   */
  register(client: DeviceOwner, message: Device): { device: Device; replays: TopicEntry[] } {
    const before = this.#devices.get(message.id);
    if (before !== undefined && before.client !== client) {
      throw new ServiceError(
        'already_exists', // [DV-2]
        `The device id ${quote(message.id)} belongs to a device of another client. Omit the id to get a new one.`,
      );
    }
    requireDeviceRights(client, message);
    const byteLength = encode('ubii.devices.Device', message).byteLength;
    this.#check(client, message, byteLength, before);
    const isWatcher = message.deviceType === DeviceType.WATCHER; // it receives retained values [DV-3]
    if (before !== undefined && !isWatcher && isSame(before.device, message)) {
      return { device: before.device, replays: [] }; // [EX-76]
    }
    if (before !== undefined) this.#remove(before);

    const id = message.id === '' ? this.#context.ids.uuid() : message.id; // [DV-1]
    const taken = new Set<string>();
    const components = message.components.map((component) => {
      const isFree = !this.#componentIds.has(component.id) && !taken.has(component.id);
      const componentId = component.id !== '' && isFree ? component.id : this.#context.ids.uuid();
      taken.add(componentId);
      return this.#componentToKeep(component, componentId, id);
    });
    const device: Device = {
      ...message,
      id,
      components,
      clientId: client.id,
      tags: this.#texts.shareAll(message.tags),
    };
    return { device, replays: this.#add({ device, client, byteLength }) };
  }

  /** Removes a device of this client. Returns false when there is none, which is as well [DV-4]. */
  deregister(client: DeviceOwner, id: string): boolean {
    const registered = this.#devices.get(id);
    if (registered === undefined) return false;
    if (registered.client !== client) {
      throw new ServiceError(
        'permission_denied',
        `The device ${quote(id)} belongs to another client. Only that client may deregister it.`,
      );
    }
    this.#remove(registered);
    this.#deleteValues(registered);
    this.#context.info.announceDeviceGone(registered.device); // [CL-30]
    return true;
  }

  /** Removes every device of a client that is removed. */
  deregisterAll(client: DeviceOwner): void {
    for (const id of [...client.devices.keys()]) this.deregister(client, id);
  }

  /** The component in as little memory as it takes: it stays while its client is away. [CL-14] */
  #componentToKeep(component: Component, id: string, deviceId: string): Component {
    const texts = this.#texts;
    return {
      topic: component.topic,
      messageFormat: texts.share(component.messageFormat),
      ioType: component.ioType,
      deviceId,
      tags: texts.shareAll(component.tags),
      description: texts.share(component.description),
      id,
      name: texts.share(component.name),
      notifyConditionIds: texts.shareAll(component.notifyConditionIds),
    };
  }

  #publishers(): Map<string, Component[]> {
    if (this.#byTopic !== undefined) return this.#byTopic;
    const byTopic = new Map<string, Component[]>();
    for (const component of [...this.#devices.values()].flatMap(
      ({ device }) => device.components,
    )) {
      if (component.ioType === ComponentIOType.SUBSCRIBER || component.topic === '') continue;
      const others = byTopic.get(component.topic);
      if (others === undefined) byTopic.set(component.topic, [component]);
      else others.push(component);
    }
    return (this.#byTopic = byTopic);
  }

  #inputs(): Map<string, Set<string>> {
    if (this.#inputsByTopic !== undefined) return this.#inputsByTopic;
    const inputs = new Map<string, Set<string>>();
    for (const { device, client } of this.#devices.values()) {
      for (const { ioType, topic } of device.components) {
        if (ioType !== ComponentIOType.SUBSCRIBER || topic === '') continue;
        const clients = inputs.get(topic);
        if (clients === undefined) inputs.set(topic, new Set([client.id]));
        else clients.add(client.id);
      }
    }
    return (this.#inputsByTopic = inputs);
  }

  #check(
    client: DeviceOwner,
    message: Device,
    byteLength: number,
    before: Registered | undefined,
  ): void {
    const { limits, accounts } = this.#context;
    const { componentsPerDevice } = limits.limits;
    const { account } = client;
    if (before === undefined) accounts.require(account, RESOURCE.devices, 1);
    if (message.components.length > componentsPerDevice) {
      const text = `more than ${componentsPerDevice} components of one device`;
      throw limits.refusal('componentsPerDevice', text, client.id);
    }
    const growth = byteLength - (before?.byteLength ?? 0);
    if (growth > 0) accounts.require(account, RESOURCE.registrationBytes, growth);
  }

  #add(registered: Registered): TopicEntry[] {
    const { device, client, byteLength } = registered;
    const { subscriptions, info } = this.#context;
    this.#devices.set(device.id, registered);
    this.#byTopic = undefined;
    this.#inputsByTopic = undefined;
    client.devices.set(device.id, device);
    client.registrationRevision++;
    client.account.add(RESOURCE.devices, 1);
    client.account.add(RESOURCE.registrationBytes, byteLength);
    for (const component of device.components) {
      this.#componentIds.add(component.id);
      subscriptions.addComponent(component);
    }
    info.announceDevice(device); // [CL-30]
    // What watchers of other masters get, those masters ask for. [CU-10]
    return device.deviceType === DeviceType.WATCHER && client.home === undefined
      ? subscriptions.watch(client.subscriber, device.id) // [DV-3]
      : [];
  }

  #remove({ device, client, byteLength }: Registered): void {
    const { subscriptions } = this.#context;
    this.#devices.delete(device.id);
    this.#byTopic = undefined;
    this.#inputsByTopic = undefined;
    client.devices.delete(device.id);
    client.registrationRevision++;
    client.account.add(RESOURCE.devices, -1);
    client.account.add(RESOURCE.registrationBytes, -byteLength);
    for (const component of device.components) {
      this.#componentIds.delete(component.id);
      subscriptions.removeComponent(component);
    }
    subscriptions.unwatch(client.subscriber, device.id);
  }

  /** [TD-40] */
  #deleteValues({ device, client }: Registered): void {
    const { topics } = this.#context;
    for (const { topic, ioType } of device.components) {
      const entry = ioType === ComponentIOType.SUBSCRIBER ? undefined : topics.get(topic);
      if (entry === undefined || entry.isMasters) continue;
      // A client cannot delete values of other publishers by naming their topic in a device.
      const isNobodys = entry.owner === undefined && entry.originId === undefined;
      if (isNobodys || entry.owner === client) topics.deleteValue(entry);
    }
  }
}

/** Whether this registration says what is known already; ids that it leaves out were given by the master. */
function isSame(known: Device, message: Device): boolean {
  if (known.components.length !== message.components.length) return false;
  const components = message.components.map((component, i) => {
    const { id, deviceId } = known.components[i]!;
    return { ...component, id: component.id || id, deviceId };
  });
  const { id, clientId } = known;
  return areEqual(bytesOf(known), bytesOf({ ...message, id, clientId, components }));
}

function bytesOf(device: Device): Uint8Array {
  return encode('ubii.devices.Device', device);
}
