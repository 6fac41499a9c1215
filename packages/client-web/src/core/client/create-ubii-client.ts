import { ServiceError } from '@ubii/proto';
import type {
  DataFormat,
  DataFormatValues,
  Init,
  ServiceName,
  ServiceReplyOf,
  ServiceRequestOf,
} from '@ubii/proto';
import type { EncodedNodeMessage } from '@ubii/proto/wire';
import { within, type Clock } from '@ubii/timing';
import { ClientCalls } from '../services/client-calls.ts';
import type { ClientCounters } from './client-counters.ts';
import type { ClientOptions } from './client-options.ts';
import { profileToMessage } from '../subscriptions/component-profile.ts';
import { ConnectionError } from '../connection/connection-error.ts';
import type { ConnectionState } from '../connection/connection-state.ts';
import { Connection } from '../connection/connection.ts';
import type { Arrival } from '../connection/connection-model.ts';
import { DeviceRegistry } from '../devices/device-registry.ts';
import type { ComponentInit, DeviceInit, RegisteredDevice } from '../devices/devices.ts';
import type { EncodedListener } from '../subscriptions/encoded-record.ts';
import { withFallback } from '../callbacks/program-errors.ts';
import type { ErrorHandler } from '../ports/error-handler.ts';
import { createMemoryIdentity } from '../connection/identity.ts';
import type { Link } from '../connection/link.ts';
import type { ClientRole } from '../connection/join.ts';
import { failureOf, LEFT } from '../connection/link-failure.ts';
import { Listeners } from '../callbacks/listeners.ts';
import type { ClientPorts } from '../ports/client-ports.ts';
import { endingRecord, toWaitingRecord, waitingRecordOf } from '../publishing/publication.ts';
import { PublishBuffer } from '../publishing/publish-buffer.ts';
import type { PublishOptions } from '../publishing/publish-buffer.ts';
import { DEFAULT_RECONNECT_POLICY } from '../connection/reconnect-policy.ts';
import { Registration } from '../connection/registration.ts';
import type { ClientProfile } from '../connection/membership.ts';
import { reportingStorage } from '../connection/reporting-storage.ts';
import { RoundTripWindow } from '../connection/round-trip.ts';
import type { RoundTrip } from '../connection/round-trip.ts';
import { ServiceCalls } from '../services/service-calls.ts';
import type { SubscribeOptions, Subscription } from '../subscriptions/subscription.ts';
import { describeEstimate } from '../time/describe-estimate.ts';
import { MasterClock } from '../time/master-clock.ts';
import type { MasterTime } from '../time/master-time.ts';
import { TopicDataInbox } from '../subscriptions/topic-data-inbox.ts';
import type { TopicPattern } from '../subscriptions/topic-pattern.ts';
import { TopicSubscriptions } from '../subscriptions/topic-subscriptions.ts';
import type {
  ClientProblem,
  IdentityChange,
  ServiceCallArguments,
  UbiiClient,
  Unsubscribe,
} from './ubii-client.ts';

const DEFAULT_PUBLISH_INTERVAL_MS = 15;
const DEFAULT_SERVICE_TIMEOUT_MS = 10_000;
/** Timeout of each request to the master during `close()`, milliseconds. */
const FAREWELL_TIMEOUT_MS = 2_000;

/** A credential lives for a week; one who stays for longer gets another in time, milliseconds. [AC-13] */
const CREDENTIAL_RENEWAL_MS = 24 * 3_600_000;

/** A client on the given ports. */
export function createUbiiClient(options: ClientOptions, ports: ClientPorts): UbiiClient {
  return new Client(options, ports);
}

/** Joins the parts; each part says itself what it does. */
class Client implements UbiiClient {
  readonly reportError: ErrorHandler;
  readonly #clock: Clock;
  readonly #open: ServiceCalls;
  readonly #calls: ClientCalls;
  readonly #registration: Registration;
  readonly #connection: Connection;
  readonly #subscriptions: TopicSubscriptions;
  readonly #inbox: TopicDataInbox;
  readonly #publishes: PublishBuffer;
  readonly #devices: DeviceRegistry;
  readonly #masterClock: MasterClock;
  readonly #stampsInMasterTime: boolean;
  readonly #roundTrips = new RoundTripWindow();
  readonly #roundTripListeners: Listeners<RoundTrip>;
  readonly #problemListeners: Listeners<ClientProblem>;
  readonly #identityListeners: Listeners<IdentityChange>;
  readonly #nodeListeners: Listeners<EncodedNodeMessage>;
  /** When a new credential was asked for last, monotonic milliseconds. */
  #credentialMs: number;
  #isLeaving = false;
  #recordsOut = 0;
  #bytesOut = 0;
  #closing: Promise<void> | undefined;

  constructor(options: ClientOptions, ports: ClientPorts) {
    const { clock, random, patterns, uuid, services, topicData, reportError } = ports;
    this.#clock = clock;
    this.#credentialMs = clock.monotonicMs();
    const onError = withFallback(options.onError ?? reportError, reportError);
    this.reportError = onError;
    this.#roundTripListeners = new Listeners(onError);
    this.#problemListeners = new Listeners(onError);
    this.#identityListeners = new Listeners(onError);
    this.#nodeListeners = new Listeners(onError);
    const timeoutMs = options.serviceTimeoutMs ?? DEFAULT_SERVICE_TIMEOUT_MS;
    const bearer = (): string | undefined => this.#registration.credential; // [AC-13]
    this.#open = new ServiceCalls(services, clock, timeoutMs, bearer);
    // Of its own, because `close()` rejects the program's calls but has to know how a registration went.
    const registrationCalls = new ServiceCalls(services, clock, timeoutMs, bearer);
    this.#registration = new Registration(
      registrationCalls,
      reportingStorage(options.identity ?? createMemoryIdentity(), onError),
      {
        name: options.name,
        description: options.description ?? '',
        tags: options.tags ?? [],
        node: options.node,
        processingModules: options.processingModules ?? [],
        isDedicatedNode: options.isDedicatedNode ?? false,
      },
      options.joinToken,
    );
    this.#calls = new ClientCalls({
      calls: this.#open,
      clock,
      timeoutMs,
      connection: () => this.#connection,
      registration: this.#registration,
    });
    const handleProblem = (problem: ClientProblem): void => this.#problemListeners.emit(problem);
    const handleUnknownClient = (cause: ServiceError): void => {
      this.#connection.drop(new ConnectionError('refused', cause.message, { cause }));
    };
    this.#subscriptions = new TopicSubscriptions({
      clock,
      patterns,
      callTopicSubscription: (request) => this.#calls.callAsMember('topicSubscription', request),
      listTopics: async () => (await this.#calls.callNow('topicList', undefined)).elements,
      listComponents: async (profiles) => {
        const elements = profiles.map(profileToMessage);
        return (await this.#calls.callNow('componentGetList', { elements })).elements;
      },
      handleProblem,
      handleUnknownClient,
      onError,
    });
    this.#inbox = new TopicDataInbox({
      handleRecord: (record) => this.#subscriptions.handleRecord(record),
      handleNodeMessage: (message) => this.#nodeListeners.emit(message),
      takesEncoded: () => this.#subscriptions.hasEncoded || this.#nodeListeners.size > 0,
      handleProblem,
      countAtMaster: (topic) => this.#subscriptions.countAtMaster(topic),
    });
    this.#devices = new DeviceRegistry({
      clock,
      uuid,
      clientId: () => this.id,
      registerDevice: (device) => this.#calls.callAsMember('deviceRegistration', device),
      deregisterDevice: (device) => this.#calls.callAsMember('deviceDeregistration', device),
      endTopic: (topic) => this.endTopic(topic),
      publish: (topic, format, value, publishOptions) =>
        this.#publish(topic, format, value, publishOptions),
      subscribe: (topic, subscribeOptions) => this.subscribe(topic, subscribeOptions),
      handleProblem,
      handleUnknownClient,
    });
    this.#stampsInMasterTime = options.stampInMasterTime ?? false;
    this.#masterClock = new MasterClock(clock, () => this.#connection.link?.measureTime(), onError);
    this.#connection = new Connection({
      clock,
      random,
      policy: { ...DEFAULT_RECONNECT_POLICY, ...options.reconnect },
      registration: this.#registration,
      transport: topicData,
      openTimeoutMs: timeoutMs,
      freshenServices: () => registrationCalls.freshen(),
      handleBinary: (bytes) => this.#inbox.handleBinary(bytes),
      handleUnknownText: (text) => this.#inbox.handleUnknownText(text),
      handleRoundTrip: (roundTripMs) => {
        this.#roundTripListeners.emit(this.#roundTrips.add(roundTripMs));
        if (this.state.status === 'connected') this.#tellProfileInPassing();
      },
      time: {
        handleLink: () => this.#masterClock.handleLink(),
        handleExchange: (exchange) => this.#masterClock.handleExchange(exchange),
        describeClock: () => describeEstimate(this.#masterClock.estimate),
      },
      restore: (arrival) => this.#restore(arrival),
      onError,
    });
    this.#publishes = new PublishBuffer(
      clock,
      this.#createSink(),
      options.publishIntervalMs ?? DEFAULT_PUBLISH_INTERVAL_MS,
    );
    this.#connection.onState((state) => this.#handleState(state));
  }

  get id(): string {
    return this.#registration.clientId;
  }

  get name(): string {
    return this.#registration.profile.name;
  }

  get authorization(): string | undefined {
    const { credential } = this.#registration;
    return credential === undefined ? undefined : `Bearer ${credential}`;
  }

  get role(): ClientRole | undefined {
    return this.#registration.membership?.role;
  }

  get state(): ConnectionState {
    return this.#connection.state;
  }

  get roundTrip(): RoundTrip | undefined {
    return this.#roundTrips.current;
  }

  get masterTime(): MasterTime {
    return this.#masterClock;
  }

  get counters(): ClientCounters {
    const { recordsIn, bytesIn, decodeErrors } = this.#inbox;
    return {
      recordsIn,
      recordsOut: this.#recordsOut,
      bytesIn,
      bytesOut: this.#bytesOut,
      recordsDropped: this.#publishes.dropped,
      decodeErrors,
    };
  }

  get bufferedBytes(): number {
    return this.#publishes.waitingBytes + (this.#connection.link?.bufferedBytes ?? 0);
  }

  onState(fn: (state: ConnectionState) => void): Unsubscribe {
    return this.#connection.onState(fn);
  }

  onRoundTrip(fn: (roundTrip: RoundTrip) => void): Unsubscribe {
    return this.#roundTripListeners.add(fn);
  }

  onError(fn: (problem: ClientProblem) => void): Unsubscribe {
    return this.#problemListeners.add(fn);
  }

  onIdentityChange(fn: (change: IdentityChange) => void): Unsubscribe {
    return this.#identityListeners.add(fn);
  }

  async connect(): Promise<void> {
    await this.#closing;
    await this.#connection.connect();
  }

  async join(token: string): Promise<void> {
    this.#registration.joinWith(token);
    if (this.state.status !== 'connected') {
      try {
        await this.connect();
      } catch (error) {
        // An attempt that had begun before did not know of it.
        if (this.#registration.hasTriedToken) throw error;
        await this.connect();
      }
      if (this.#registration.hasTriedToken) return;
    }
    try {
      await this.#tellProfile();
    } catch (error) {
      throw error instanceof ServiceError ? failureOf(error).error : error;
    }
  }

  retryNow(): void {
    this.#connection.retryNow();
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
    this.#publishes.flush();
    this.#isLeaving = true;
    const { link } = this.#connection.close(LEFT);
    this.#isLeaving = false;
    this.#registration.invalidate();
    link?.close(LEFT.code, LEFT.reason);
  }

  rename(name: string): Promise<void> {
    return this.updateProfile({ name });
  }

  async updateProfile(change: Partial<ClientProfile>): Promise<void> {
    this.#registration.describe(change);
    if (this.state.status !== 'connected') return;
    try {
      await this.#tellProfile();
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
    this.#publish(topic, format, value, options);
  }

  setPublishIntervalMs(intervalMs: number): void {
    this.#publishes.setIntervalMs(intervalMs);
  }

  subscribe<F extends DataFormat = DataFormat>(
    pattern: string | TopicPattern,
    options: SubscribeOptions<F> = {},
  ): Subscription<F> {
    return this.#subscriptions.subscribe(
      typeof pattern === 'string' ? { topic: pattern } : pattern,
      options,
    );
  }

  subscribeEncoded(pattern: string | TopicPattern, listener: EncodedListener): Unsubscribe {
    return this.#subscriptions.subscribeEncoded(
      typeof pattern === 'string' ? { topic: pattern } : pattern,
      listener,
    );
  }

  endTopic(topic: string): void {
    const timestampMs = (this.#stampsInMasterTime ? this.#masterClock : this.#clock).nowMs();
    this.#publishes.add(endingRecord({ topic, timestampMs, clientId: this.id }), true);
  }

  publishEncoded(topic: string, record: Uint8Array, valueField: number): void {
    this.#publishes.add(waitingRecordOf(topic, record, valueField), false);
    this.#publishes.flushSoon();
  }

  onNodeMessage(fn: (message: EncodedNodeMessage) => void): Unsubscribe {
    return this.#nodeListeners.add(fn);
  }

  sendNodeMessage(frame: Uint8Array): boolean {
    const { link } = this.#connection;
    if (link === undefined || !this.#calls.isExtended) return false;
    this.#publishes.flush();
    link.sendBinary(frame);
    this.#bytesOut += frame.byteLength;
    return true;
  }

  call<S extends ServiceName>(
    service: S,
    ...[request]: ServiceCallArguments<S>
  ): Promise<ServiceReplyOf<S>> {
    return this.#calls.call(service, request as Init<ServiceRequestOf<S>> | undefined);
  }

  async registerDevice<const C extends readonly ComponentInit[]>(
    device: DeviceInit<C>,
  ): Promise<RegisteredDevice<C>> {
    // The names and formats in the type are those of `device`.
    return (await this.#devices.register(device)) as unknown as RegisteredDevice<C>;
  }

  #publish(topic: string, format: DataFormat, value: unknown, options: PublishOptions = {}): void {
    const inMasterTime = options.stampInMasterTime ?? this.#stampsInMasterTime;
    const clock = inMasterTime ? this.#masterClock : this.#clock; // [TS-9]
    const timestampMs = options.timestampMs ?? clock.nowMs();
    this.#publishes.add(
      toWaitingRecord({
        topic,
        format,
        value,
        timestampMs,
        clientId: this.id,
        keepSeconds: options.keepSeconds,
        expiryMs: options.expiryMs,
      }),
      options.immediate === true,
    );
  }

  async #tellProfile(): Promise<void> {
    const idBefore = this.id;
    await this.#registration.update();
    if (this.id === idBefore) return;
    this.#connection.drop(
      new ConnectionError('closed', 'The master gave the client another id when it was renamed'),
    );
  }

  /** Ignores a failed change of the name: it is retried with every PING. */
  #tellProfileInPassing(): void {
    const nowMs = this.#clock.monotonicMs();
    if (nowMs - this.#credentialMs > CREDENTIAL_RENEWAL_MS) {
      this.#credentialMs = nowMs;
      this.#registration.renewCredential();
    }
    this.#tellProfile().catch(() => undefined);
  }

  async #restore({ membership, previousId }: Arrival): Promise<void> {
    const { identity, isExtended, serial } = membership;
    this.#inbox.handleMaster(isExtended);
    const { clientId } = identity;
    await Promise.all([
      this.#devices.resume({ serial, canKeepIds: isExtended }),
      this.#subscriptions.resume({ clientId, takesComponents: isExtended }),
    ]);
    if (previousId !== '' && previousId !== clientId) {
      this.#identityListeners.emit({ previousId, clientId });
    }
  }

  #handleState(state: ConnectionState): void {
    switch (state.status) {
      case 'connected':
        this.#publishes.flush();
        this.#tellProfileInPassing(); // renamed while it was connecting
        return;
      case 'reconnecting':
        this.#pause();
        return;
      case 'closed':
        this.#pause();
        // Do not cancel the requests that a page sends while it closes.
        if (this.#isLeaving) return;
        this.#open.rejectAll(state.error ?? new ConnectionError('closed', 'The client was closed'));
        if (state.error !== undefined) this.#subscriptions.failIterators(state.error);
        return;
      case 'idle':
      case 'connecting':
        return;
    }
  }

  #pause(): void {
    this.#subscriptions.pause();
    this.#devices.pause();
    this.#roundTrips.clear();
  }

  async #close(): Promise<void> {
    this.#publishes.flush();
    this.#publishes.clear();
    const { link, registered } = this.#connection.close();
    this.#subscriptions.closeAll();
    this.#devices.clear(new ConnectionError('closed', 'The client was closed'));
    // Deregistering goes another way and would overtake the last records. [TD-40]
    if (link !== undefined) await within(this.#clock, FAREWELL_TIMEOUT_MS, link.handled());
    // An attempt that was under way may be registering the client this moment.
    await within(this.#clock, FAREWELL_TIMEOUT_MS, registered);
    try {
      await this.#registration.deregister(FAREWELL_TIMEOUT_MS);
    } catch (error) {
      // The master is gone, or has forgotten the client already: left either way.
      if (!(error instanceof ServiceError) && !(error instanceof ConnectionError)) throw error;
    }
    link?.close();
  }

  #createSink() {
    const link = (): Link | undefined => this.#connection.link;
    return {
      get isOpen() {
        return link() !== undefined;
      },
      get bufferedBytes() {
        return link()?.bufferedBytes ?? 0;
      },
      send: (frame: Uint8Array, recordCount: number): void => {
        link()?.sendBinary(frame);
        this.#recordsOut += recordCount;
        this.#bytesOut += frame.byteLength;
      },
    };
  }
}
