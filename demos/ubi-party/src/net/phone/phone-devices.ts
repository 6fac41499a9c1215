import type { RegisteredDevice, UbiiClient } from '@ubii/client-web';
import {
  PHONE_DEVICE,
  phoneTopic,
  SEAT_COMPONENTS,
  SEAT_DEVICE,
  WATCH_COMPONENTS,
  type PhoneComponent,
} from '../protocol.ts';

/** Registers the phone's devices: few components while it watches, those of the controller while it has a seat. */
export class PhoneDevices {
  readonly #client: UbiiClient;
  #watching: RegisteredDevice | undefined;
  #seated: RegisteredDevice | undefined;
  #isSeated = false;
  /** One change after the other. */
  #turn: Promise<unknown> = Promise.resolve();

  constructor(client: UbiiClient) {
    this.#client = client;
  }

  async open(): Promise<void> {
    this.#watching = await this.#register(PHONE_DEVICE, WATCH_COMPONENTS);
  }

  get isSeated(): boolean {
    return this.#isSeated;
  }

  /** @returns whether this changed something */
  setSeated(isSeated: boolean): boolean {
    if (this.#isSeated === isSeated) return false;
    this.#isSeated = isSeated;
    this.#turn = this.#turn
      .then(() => this.#change())
      // The game is played without: the device is for those who look at the clients
      .catch(() => undefined);
    return true;
  }

  close(): void {
    void this.#watching?.close();
    this.setSeated(false);
  }

  async #change(): Promise<void> {
    if (this.#isSeated) {
      this.#seated ??= await this.#register(SEAT_DEVICE, SEAT_COMPONENTS);
      return;
    }
    const seated = this.#seated;
    this.#seated = undefined;
    for (const [name, { ioType }] of Object.entries(SEAT_COMPONENTS)) {
      if (ioType === 'publisher')
        this.#client.endTopic(phoneTopic(this.#client.id, name as PhoneComponent));
    }
    await seated?.close();
  }

  async #register(
    name: string,
    components: typeof WATCH_COMPONENTS | typeof SEAT_COMPONENTS,
  ): Promise<RegisteredDevice> {
    const device = await this.#client.registerDevice({
      name,
      components: Object.entries(components).map(([component, { format, ioType }]) => ({
        name: component,
        format,
        ioType,
        tags: ['party'],
        topic: (clientId: string) => phoneTopic(clientId, component as PhoneComponent),
      })),
      tags: ['party'],
    });
    return device as unknown as RegisteredDevice;
  }
}
