import type { DataFormat, DataFormatValues } from '@ubii/proto';
import type { PublishOptions } from '../publishing/publish-buffer.ts';
import type { SubscribeOptions, Subscription } from '../subscriptions/subscription.ts';

/** One data stream of a device, as a program describes it. */
export interface ComponentInit<F extends DataFormat = DataFormat> {
  readonly name: string;
  readonly format: F;
  /** `publisher`: the device sends; `subscriber`: it receives. @default 'publisher' */
  readonly ioType?: 'publisher' | 'subscriber';
  /**
   * The topic, or what makes it of the client's id, which another connection may change.
   * @default '/<client id>/<device name>/<component name>'
   */
  readonly topic?: string | ((clientId: string) => string);
  readonly tags?: readonly string[];
  readonly description?: string;
}

/** A device, as a program describes it. */
export interface DeviceInit<C extends readonly ComponentInit[] = readonly ComponentInit[]> {
  readonly name: string;
  readonly components: C;
  /** A `watcher` receives every topic. @default 'participant' */
  readonly type?: 'participant' | 'watcher';
  readonly tags?: readonly string[];
  readonly description?: string;
}

/** One data stream of a registered device. */
export interface RegisteredComponent<F extends DataFormat = DataFormat> {
  readonly id: string;
  readonly name: string;
  readonly format: F;
  /** Changes with the client's id when it was not given. */
  readonly topic: string;
  /** Publishes a value on the component's topic. */
  publish(value: DataFormatValues[F], options?: PublishOptions): void;
  /** Says that the component's topic has no value any more. [TD-48] */
  end(): void;
  /** Subscribes to the component's topic, as it is now. */
  subscribe(options?: Omit<SubscribeOptions, 'format'>): Subscription<F>;
}

/** A device the master knows. It is registered again, under the same id, after a reconnect. */
export interface RegisteredDevice<C extends readonly ComponentInit[] = readonly ComponentInit[]> {
  readonly id: string;
  readonly name: string;
  /**
   * The component of this name.
   * @throws {RangeError} if the device has none
   */
  component<N extends C[number]['name']>(
    name: N,
  ): RegisteredComponent<Extract<C[number], { readonly name: N }>['format']>;
  /** Deregisters the device; idempotent. */
  close(): Promise<void>;
}
