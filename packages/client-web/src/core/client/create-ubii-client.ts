import { ServiceError } from '@ubii/proto';
import type {
  DataFormat,
  DataFormatValues,
  Init,
  Mark,
  ServiceName,
  ServiceReplyOf,
  ServiceRequestOf,
} from '@ubii/proto';
import type { EncodedNodeMessage } from '@ubii/proto/wire';
import { within, type Clock } from '@ubii/timing';
import { ConnectionError } from '../connection/connection-error.ts';
import type { ConnectionState } from '../connection/connection-state.ts';
import type { ClientRole } from '../connection/join.ts';
import { failureOf, LEFT } from '../connection/link-failure.ts';
import type { ClientProfile } from '../connection/membership.ts';
import type { MasterChange } from '../connection/moves.ts';
import type { RoundTrip } from '../connection/round-trip.ts';
import type { ComponentInit, DeviceInit, RegisteredDevice } from '../devices/devices.ts';
import type { ClientPorts } from '../ports/client-ports.ts';
import type { ErrorHandler } from '../ports/error-handler.ts';
import type { PublishOptions } from '../publishing/publish-buffer.ts';
import type { EncodedListener } from '../subscriptions/encoded-record.ts';
import type { SubscribeOptions, Subscription } from '../subscriptions/subscription.ts';
import type { TopicPattern } from '../subscriptions/topic-pattern.ts';
import type { MasterTime } from '../time/master-time.ts';
import type { ClientCounters } from './client-counters.ts';
import type { ClientOptions } from './client-options.ts';
import { ClientParts } from './client-parts.ts';
import type {
  ClientProblem,
  IdentityChange,
  ServiceCallArguments,
  UbiiClient,
  Unsubscribe,
} from './ubii-client.ts';

/** Timeout of each request to the master during `close()`, milliseconds. */
const FAREWELL_TIMEOUT_MS = 2_000;

/** A client on the given ports. */
export function createUbiiClient(options: ClientOptions, ports: ClientPorts): UbiiClient {
  return new Client(new ClientParts(options, ports), ports.clock);
}

/** What a program does with a client, and how a client ends. */
class Client implements UbiiClient {
  readonly reportError: ErrorHandler;
  readonly #clock: Clock;
  readonly #parts: ClientParts;
  #isLeaving = false;
  #closing: Promise<void> | undefined;

  constructor(parts: ClientParts, clock: Clock) {
    this.#parts = parts;
    this.#clock = clock;
    this.reportError = parts.reportError;
    parts.connection.onState((state) => this.#handleState(state));
  }

  get id(): string {
    return this.#parts.registration.clientId;
  }

  get name(): string {
    return this.#parts.registration.profile.name;
  }

  get mark(): Init<Mark> | undefined {
    return this.#parts.registration.profile.mark;
  }

  get authorization(): string | undefined {
    const { credential } = this.#parts.registration;
    return credential === undefined ? undefined : `Bearer ${credential}`;
  }

  get role(): ClientRole | undefined {
    return this.#parts.registration.membership?.role;
  }

  get state(): ConnectionState {
    return this.#parts.connection.state;
  }

  get roundTrip(): RoundTrip | undefined {
    return this.#parts.roundTrips.current;
  }

  get masterTime(): MasterTime {
    return this.#parts.masterClock;
  }

  get counters(): ClientCounters {
    const { recordsIn, bytesIn, decodeErrors } = this.#parts.inbox;
    const { recordsOut, bytesOut, dropped: recordsDropped } = this.#parts.publisher;
    return { recordsIn, recordsOut, bytesIn, bytesOut, recordsDropped, decodeErrors };
  }

  get bufferedBytes(): number {
    return this.#parts.publisher.bufferedBytes;
  }

  onState(fn: (state: ConnectionState) => void): Unsubscribe {
    return this.#parts.connection.onState(fn);
  }

  onRoundTrip(fn: (roundTrip: RoundTrip) => void): Unsubscribe {
    return this.#parts.roundTripListeners.add(fn);
  }

  onError(fn: (problem: ClientProblem) => void): Unsubscribe {
    return this.#parts.problemListeners.add(fn);
  }

  get masterUrl(): string | undefined {
    return this.#parts.masters.url;
  }

  get otherMasters(): readonly string[] {
    return this.#parts.masters.others;
  }

  onMaster(fn: (change: MasterChange) => void): Unsubscribe {
    return this.#parts.moves.onMaster(fn);
  }

  onIdentityChange(fn: (change: IdentityChange) => void): Unsubscribe {
    return this.#parts.identityListeners.add(fn);
  }

  async connect(): Promise<void> {
    await this.#closing;
    await this.#parts.connection.connect();
  }

  async join(token: string): Promise<void> {
    this.#parts.registration.joinWith(token);
    if (this.state.status !== 'connected') {
      try {
        await this.connect();
      } catch (error) {
        // An attempt that had begun before did not know of it.
        if (this.#parts.registration.hasTriedToken) throw error;
        await this.connect();
      }
      if (this.#parts.registration.hasTriedToken) return;
    }
    try {
      await this.#parts.profile.tell();
    } catch (error) {
      throw error instanceof ServiceError ? failureOf(error).error : error;
    }
  }

  retryNow(): void {
    this.#parts.connection.retryNow();
  }

  close(): Promise<void> {
    if (this.state.status === 'closed' && this.state.error === undefined) {
      return this.#closing ?? Promise.resolve();
    }
    this.#closing ??= this.#close().finally(() => {
      this.#closing = undefined;
    });
    return this.#closing;
  }

  leave(): void {
    if (this.state.status === 'closed') return;
    this.#parts.publisher.flush();
    this.#isLeaving = true;
    const { link } = this.#parts.connection.close(LEFT);
    this.#isLeaving = false;
    this.#parts.registration.invalidate();
    link?.close(LEFT.code, LEFT.reason);
  }

  rename(name: string): Promise<void> {
    return this.updateProfile({ name });
  }

  async updateProfile(change: Partial<ClientProfile>): Promise<void> {
    this.#parts.registration.describe(change);
    if (this.state.status !== 'connected') return;
    try {
      await this.#parts.profile.tell();
    } catch (error) {
      if (!(error instanceof ConnectionError)) throw error; // else it is told later
    }
  }

  publish<F extends DataFormat>(
    topic: string,
    format: F,
    value: DataFormatValues[F],
    options?: PublishOptions,
  ): void {
    this.#parts.publisher.publish(topic, format, value, options);
  }

  setPublishIntervalMs(intervalMs: number): void {
    this.#parts.publisher.setIntervalMs(intervalMs);
  }

  subscribe<F extends DataFormat = DataFormat>(
    pattern: string | TopicPattern,
    options: SubscribeOptions<F> = {},
  ): Subscription<F> {
    return this.#parts.subscriptions.subscribe(
      typeof pattern === 'string' ? { topic: pattern } : pattern,
      options,
    );
  }

  subscribeEncoded(pattern: string | TopicPattern, listener: EncodedListener): Unsubscribe {
    return this.#parts.subscriptions.subscribeEncoded(
      typeof pattern === 'string' ? { topic: pattern } : pattern,
      listener,
    );
  }

  endTopic(topic: string): void {
    this.#parts.publisher.endTopic(topic);
  }

  publishEncoded(topic: string, record: Uint8Array, valueField: number): void {
    this.#parts.publisher.publishEncoded(topic, record, valueField);
  }

  onNodeMessage(fn: (message: EncodedNodeMessage) => void): Unsubscribe {
    return this.#parts.nodeListeners.add(fn);
  }

  sendNodeMessage(frame: Uint8Array): boolean {
    const { calls, publisher } = this.#parts;
    return calls.isExtended && publisher.sendFrame(frame);
  }

  call<S extends ServiceName>(
    service: S,
    ...[request]: ServiceCallArguments<S>
  ): Promise<ServiceReplyOf<S>> {
    return this.#parts.calls.call(service, request as Init<ServiceRequestOf<S>> | undefined);
  }

  async registerDevice<const C extends readonly ComponentInit[]>(
    device: DeviceInit<C>,
  ): Promise<RegisteredDevice<C>> {
    // The names and formats in the type are those of `device`.
    return (await this.#parts.devices.register(device)) as unknown as RegisteredDevice<C>;
  }

  #handleState(state: ConnectionState): void {
    switch (state.status) {
      case 'connected':
        this.#parts.publisher.flush();
        this.#parts.profile.sendInBackground(); // renamed while it was connecting
        return;
      case 'reconnecting':
        this.#pause();
        return;
      case 'closed':
        this.#pause();
        // Do not cancel the requests that a page sends while it closes.
        if (this.#isLeaving) return;
        this.#parts.programCalls.rejectAll(
          state.error ?? new ConnectionError('closed', 'The client was closed'),
        );
        if (state.error !== undefined) this.#parts.subscriptions.failIterators(state.error);
        return;
      case 'idle':
      case 'connecting':
        return;
    }
  }

  #pause(): void {
    this.#parts.subscriptions.pause();
    this.#parts.devices.pause();
    this.#parts.roundTrips.clear();
  }

  async #close(): Promise<void> {
    this.#parts.publisher.flush();
    this.#parts.publisher.clear();
    const { link, registered } = this.#parts.connection.close();
    this.#parts.subscriptions.closeAll();
    this.#parts.devices.clear(new ConnectionError('closed', 'The client was closed'));
    // Deregistering goes another way and would overtake the last records. [TD-40]
    if (link !== undefined) await within(this.#clock, FAREWELL_TIMEOUT_MS, link.handled());
    // An attempt that was under way may be registering the client this moment.
    await within(this.#clock, FAREWELL_TIMEOUT_MS, registered);
    try {
      await this.#parts.registration.deregister(FAREWELL_TIMEOUT_MS);
    } catch (error) {
      // The master is gone, or has forgotten the client already: left either way.
      if (!(error instanceof ServiceError) && !(error instanceof ConnectionError)) throw error;
    }
    link?.close();
  }
}
