import { INFO_TOPICS } from '@ubii/proto';
import type { Component } from '@ubii/proto';
import type { Subscription } from '../core/subscriptions/subscription.ts';
import type { UbiiClient } from '../core/client/ubii-client.ts';

/** Dependencies of the watch on a client. */
export type DeviceClient = Pick<UbiiClient, 'subscribe' | 'call' | 'onState' | 'state'>;

/** The device of a component's topic, kept up to date while there are listeners. [PM-43] */
export class DeviceTopics {
  readonly #client: DeviceClient;
  readonly #devices = new Map<string, string>();
  #watchers = 0;
  #stopWatching: (() => void) | undefined;
  #reading: Promise<void> | undefined;

  constructor(client: DeviceClient) {
    this.#client = client;
  }

  /** `undefined` when there is none, or none that is known yet. */
  deviceOf(topic: string): string | undefined {
    return this.#devices.get(topic);
  }

  /** Resolves when the devices that are there are known; `undefined` when nothing is being asked. */
  get reading(): Promise<void> | undefined {
    return this.#reading;
  }

  watch(): void {
    this.#watchers += 1;
    if (this.#watchers === 1) this.#stopWatching = this.#start();
  }

  unwatch(): void {
    this.#watchers -= 1;
    if (this.#watchers > 0) return;
    this.#stopWatching?.();
    this.#stopWatching = undefined;
    this.#devices.clear();
  }

  #start(): () => void {
    const added = this.#client.subscribe(INFO_TOPICS.newDevice, { format: 'device' });
    const removed = this.#client.subscribe(INFO_TOPICS.deleteDevice, { format: 'device' });
    added.onRecord(({ value }) => this.#add(value.components));
    removed.onRecord(({ value }) => {
      for (const { topic } of value.components) {
        if (this.#devices.get(topic) === value.id) this.#devices.delete(topic);
      }
    });
    const stopListening = this.#client.onState(({ status }) => {
      if (status === 'connected') this.#readAll();
    });
    if (this.#client.state.status === 'connected') this.#readAll();
    const subscriptions: Subscription<'device'>[] = [added, removed];
    return () => {
      stopListening();
      for (const subscription of subscriptions) void subscription.close();
    };
  }

  /** Devices that are there already. What was missed is asked for again with the next connection. */
  #readAll(): void {
    const reading: Promise<void> = this.#client
      .call('componentGetList')
      .then(
        ({ elements }) => {
          if (this.#watchers > 0) this.#add(elements);
        },
        () => undefined,
      )
      .finally(() => {
        if (this.#reading === reading) this.#reading = undefined;
      });
    this.#reading = reading;
  }

  #add(components: readonly Component[]): void {
    for (const { topic, deviceId } of components) {
      if (topic !== '' && deviceId !== '') this.#devices.set(topic, deviceId);
    }
  }
}
