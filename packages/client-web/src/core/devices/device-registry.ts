import { ComponentIOType, DeviceType, ServiceError, componentTopic } from '@ubii/proto';
import type { DataFormat, Device, Init } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import { messageFormatOf } from '../subscriptions/component-profile.ts';
import { ConnectionError } from '../connection/connection-error.ts';
import { Deferred } from '../callbacks/deferred.ts';
import type {
  ComponentInit,
  DeviceInit,
  RegisteredComponent,
  RegisteredDevice,
} from './devices.ts';
import { isUnknownClient } from '../connection/link-failure.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { PublishOptions } from '../publishing/publish-buffer.ts';
import type { SubscribeOptions, Subscription } from '../subscriptions/subscription.ts';

/** Dependencies of devices on their client. */
export interface DeviceRegistryOptions {
  readonly clock: Clock;
  readonly uuid: IdSource;
  readonly clientId: () => string;
  readonly registerDevice: (device: Init<Device>) => Promise<Device>;
  readonly deregisterDevice: (device: Init<Device>) => Promise<unknown>;
  /** Value and format fit each other. */
  readonly publish: (
    topic: string,
    format: DataFormat,
    value: unknown,
    options?: PublishOptions,
  ) => void;
  readonly endTopic: (topic: string) => void;
  readonly subscribe: (topic: string, options: SubscribeOptions) => Subscription;
  /** The master did not take a device back after a reconnect. */
  readonly handleProblem: (error: ServiceError) => void;
  readonly handleUnknownClient: (error: ServiceError) => void;
}

/** Delay after a request that failed while connected, milliseconds. */
const RETRY_MS = 1_000;

/** A device of the program, registered or about to be. */
interface Entry {
  readonly init: DeviceInit;
  /**
   * Chosen here, so that a registration whose answer got lost can be repeated, or undone, without
   * leaving a second device behind. An original master refuses an id it has, so there it is not sent.
   */
  id: string;
  /** Whether the master may have it. */
  wasAsked: boolean;
  /** The registration of the client it was registered under; after another one the master may have lost it. */
  serial: number | undefined;
  /** The latest reply of the master. */
  registered: Device | undefined;
  /** Settles when the device is registered for the first time. */
  readonly first: Deferred<void>;
}

/** The devices of the program: registered when there is a connection, and again after each reconnect. */
export class DeviceRegistry {
  readonly #options: DeviceRegistryOptions;
  readonly #entries = new Set<Entry>();
  /** Ids of devices that were closed while there was no connection. */
  readonly #leftBehind = new Set<string>();
  readonly #retries = new Set<Cancel>();
  #isOnline = false;
  #canKeepIds = false;
  #serial = 0;

  constructor(options: DeviceRegistryOptions) {
    this.#options = options;
  }

  /**
   * @throws {TypeError} if the device or a component has no name, or two components have the same
   * @throws {ServiceError} if the master refuses the device
   */
  async register(init: DeviceInit): Promise<RegisteredDevice> {
    checkNames(init);
    const entry: Entry = {
      init,
      id: this.#options.uuid(),
      wasAsked: false,
      serial: undefined,
      registered: undefined,
      first: new Deferred(),
    };
    this.#entries.add(entry);
    if (this.#isOnline) await this.#registerWhileOnline(entry);
    await entry.first.promise;
    return this.#toRegisteredDevice(entry);
  }

  /**
   * The link is up.
   * @param link `serial`: the client's registration; `canKeepIds`: it takes a device back under its id [DV-2]
   * @throws {ConnectionError | ServiceError} if the link failed, or the master does not know the client
   */
  async resume(link: { serial: number; canKeepIds: boolean }): Promise<void> {
    this.#isOnline = true;
    this.#canKeepIds = link.canKeepIds;
    this.#serial = link.serial;
    await this.#deregisterLeftBehind();
    await Promise.all(
      [...this.#entries].map(async (entry) => {
        if (entry.registered === undefined) await this.#registerFirst(entry);
        else if (entry.serial !== link.serial) await this.#registerAgain(entry);
      }),
    );
  }

  /** The link is gone. */
  pause(): void {
    this.#isOnline = false;
    for (const cancel of this.#retries) cancel();
    this.#retries.clear();
  }

  /** Forgets all devices; the master ends them with the client. */
  clear(error: ConnectionError): void {
    this.pause();
    for (const { first } of this.#entries) first.reject(error);
    this.#entries.clear();
    this.#leftBehind.clear();
  }

  async #registerWhileOnline(entry: Entry): Promise<void> {
    try {
      await this.#registerFirst(entry);
    } catch (error) {
      this.#options.handleUnknownClient(error as ServiceError);
    }
  }

  /** @throws {ServiceError} only if the master does not know the client; all else goes to who waits for the device */
  async #registerFirst(entry: Entry): Promise<void> {
    try {
      await this.#register(entry);
      entry.first.resolve();
    } catch (error) {
      if (isUnknownClient(error)) throw error; // the next `resume` tries again
      if (error instanceof ConnectionError && error.reason !== 'protocol') {
        // The caller waits for it.
        this.#retryLater(async () => {
          if (this.#entries.has(entry)) await this.#registerWhileOnline(entry);
        });
        return;
      }
      this.#entries.delete(entry);
      entry.first.reject(error);
    }
  }

  /** For a request that did not get through though the link is up; when it is not, `resume` does it. */
  #retryLater(retry: () => Promise<void>): void {
    if (!this.#isOnline) return;
    const cancel = this.#options.clock.after(RETRY_MS, () => {
      this.#retries.delete(cancel);
      void retry();
    });
    this.#retries.add(cancel);
  }

  async #registerAgain(entry: Entry): Promise<void> {
    try {
      await this.#register(entry);
    } catch (error) {
      if (!(error instanceof ServiceError) || isUnknownClient(error)) throw error;
      this.#options.handleProblem(error);
    }
  }

  async #register(entry: Entry): Promise<void> {
    const serial = this.#serial;
    entry.wasAsked = true;
    try {
      entry.registered = await this.#ask(entry);
      entry.id = entry.registered.id;
      entry.serial = serial;
    } finally {
      // Closed while the request was under way, which may have overtaken the closing, or not.
      if (!this.#entries.has(entry)) await this.#deregister(entry.id);
    }
  }

  async #ask(entry: Entry): Promise<Device> {
    const { clientId, registerDevice, uuid } = this.#options;
    const ask = () => registerDevice(toMessage(entry, clientId(), this.#canKeepIds));
    try {
      return await ask();
    } catch (error) {
      if (!(error instanceof ServiceError) || error.code !== 'already_exists') throw error;
      entry.id = uuid(); // another client has this id by now
      return ask();
    }
  }

  async #close(entry: Entry): Promise<void> {
    if (this.#entries.delete(entry) && entry.wasAsked) await this.#deregister(entry.id);
  }

  async #deregister(id: string): Promise<void> {
    this.#leftBehind.add(id);
    if (this.#isOnline) await this.#deregisterLeftBehind();
  }

  async #deregisterLeftBehind(): Promise<void> {
    for (const id of [...this.#leftBehind]) {
      try {
        await this.#options.deregisterDevice({ id, clientId: this.#options.clientId() });
      } catch (error) {
        if (!(error instanceof ServiceError)) {
          this.#retryLater(() => this.#deregisterLeftBehind());
          return;
        }
      }
      this.#leftBehind.delete(id);
    }
  }

  #toRegisteredDevice(entry: Entry): RegisteredDevice {
    const components = new Map(
      entry.init.components.map((init, index) => [
        init.name,
        this.#toComponent(entry, init, index),
      ]),
    );
    return {
      get id() {
        return entry.id;
      },
      name: entry.init.name,
      component: (name) => {
        const component = components.get(name);
        if (component !== undefined) return component;
        throw new RangeError(
          `Expected a component of the device "${entry.init.name}" (${[...components.keys()].join(', ')}), received "${name}"`,
        );
      },
      close: () => this.#close(entry),
    };
  }

  #toComponent(entry: Entry, init: ComponentInit, index: number): RegisteredComponent {
    const { publish, endTopic, subscribe } = this.#options;
    // [DV-1] the reply repeats the components in their order.
    const registered = () => entry.registered?.components[index];
    return {
      get id() {
        return registered()?.id ?? '';
      },
      name: init.name,
      format: init.format,
      get topic() {
        return registered()?.topic ?? '';
      },
      publish(value, options) {
        publish(this.topic, init.format, value, options);
      },
      end() {
        endTopic(this.topic);
      },
      subscribe(options) {
        return subscribe(this.topic, { ...options, format: init.format });
      },
    };
  }
}

function toMessage(
  { init, id, registered }: Entry,
  clientId: string,
  keepsIds: boolean,
): Init<Device> {
  return {
    ...(keepsIds ? { id } : {}),
    clientId,
    name: init.name,
    deviceType: init.type === 'watcher' ? DeviceType.WATCHER : DeviceType.PARTICIPANT,
    ...(init.tags?.length ? { tags: [...init.tags] } : {}),
    ...(init.description ? { description: init.description } : {}),
    components: init.components.map((component, index) => ({
      ...(keepsIds && registered?.components[index]?.id
        ? { id: registered.components[index].id }
        : {}),
      name: component.name,
      topic: topicOf(component, clientId, init.name),
      messageFormat: messageFormatOf(component.format),
      ioType:
        component.ioType === 'subscriber' ? ComponentIOType.SUBSCRIBER : ComponentIOType.PUBLISHER,
      ...(component.tags?.length ? { tags: [...component.tags] } : {}),
      ...(component.description ? { description: component.description } : {}),
    })),
  };
}

function topicOf({ topic, name }: ComponentInit, clientId: string, deviceName: string): string {
  if (typeof topic === 'function') return topic(clientId);
  return topic ?? componentTopic(clientId, deviceName, name);
}

function checkNames({ name, components }: DeviceInit): void {
  if (name === '') throw new TypeError('Expected a device with a name, received an empty one');
  const names = new Set(components.map((component) => component.name));
  if (names.has('')) throw new TypeError(`Expected components with names in the device "${name}"`);
  if (names.size < components.length) {
    throw new TypeError(`Expected components with different names in the device "${name}"`);
  }
}
