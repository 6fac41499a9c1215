import { MASTERS_TOPIC, type ServiceError } from '@ubii/proto';
import type { EncodedNodeMessage } from '@ubii/proto/wire';
import { Listeners } from '../callbacks/listeners.ts';
import { withFallback } from '../callbacks/program-errors.ts';
import { ConnectionError } from '../connection/connection-error.ts';
import type { Arrival } from '../connection/connection-model.ts';
import { Connection } from '../connection/connection.ts';
import { createMemoryIdentity } from '../connection/identity.ts';
import { Masters } from '../connection/masters.ts';
import { Moves } from '../connection/moves.ts';
import { ProfileSync } from '../connection/profile-sync.ts';
import { Proofs } from '../connection/proofs.ts';
import { DEFAULT_RECONNECT_POLICY, type ReconnectPolicy } from '../connection/reconnect-policy.ts';
import { Registration } from '../connection/registration.ts';
import { SendTimes } from '../connection/send-times.ts';
import { reportingStorage } from '../connection/reporting-storage.ts';
import { RoundTripWindow, type RoundTrip } from '../connection/round-trip.ts';
import { Scout } from '../connection/scout.ts';
import { DeviceRegistry } from '../devices/device-registry.ts';
import type { ClientPorts } from '../ports/client-ports.ts';
import type { ErrorHandler } from '../ports/error-handler.ts';
import { Publisher } from '../publishing/publisher.ts';
import { ClientCalls } from '../services/client-calls.ts';
import { ServiceCalls } from '../services/service-calls.ts';
import { profileToMessage } from '../subscriptions/component-profile.ts';
import { TopicDataInbox } from '../subscriptions/topic-data-inbox.ts';
import { TopicSubscriptions } from '../subscriptions/topic-subscriptions.ts';
import { describeEstimate } from '../time/describe-estimate.ts';
import { MasterClock } from '../time/master-clock.ts';
import type { ClientOptions } from './client-options.ts';
import type { ClientProblem, IdentityChange } from './ubii-client.ts';

const DEFAULT_PUBLISH_INTERVAL_MS = 15;
const DEFAULT_SERVICE_TIMEOUT_MS = 10_000;

/** The parts of a client and how they are joined; each part says itself what it does. */
export class ClientParts {
  readonly reportError: ErrorHandler;
  /** Calls of the program, which end when the client is closed. */
  readonly programCalls: ServiceCalls;
  readonly calls: ClientCalls;
  readonly registration: Registration;
  readonly masters: Masters;
  readonly moves: Moves;
  readonly profile: ProfileSync;
  readonly connection: Connection;
  readonly subscriptions: TopicSubscriptions;
  readonly inbox: TopicDataInbox;
  readonly publisher: Publisher;
  readonly devices: DeviceRegistry;
  readonly masterClock: MasterClock;
  readonly roundTrips = new RoundTripWindow();
  readonly roundTripListeners: Listeners<RoundTrip>;
  readonly problemListeners: Listeners<ClientProblem>;
  readonly identityListeners: Listeners<IdentityChange>;
  readonly nodeListeners: Listeners<EncodedNodeMessage>;
  readonly #options: ClientOptions;
  readonly #ports: ClientPorts;
  readonly #timeoutMs: number;
  readonly #sendTimes: SendTimes;
  readonly #proofs = new Proofs();
  #hearsOfMasters = false;

  constructor(options: ClientOptions, ports: ClientPorts) {
    const { clock } = ports;
    this.#sendTimes = new SendTimes(clock);
    this.masters = new Masters(ports.master, ports.waysTo);
    const { services } = this.masters;
    const onError = withFallback(options.onError ?? ports.reportError, ports.reportError);
    this.#options = options;
    this.#ports = ports;
    this.#timeoutMs = options.serviceTimeoutMs ?? DEFAULT_SERVICE_TIMEOUT_MS;
    this.reportError = onError;
    this.roundTripListeners = new Listeners(onError);
    this.problemListeners = new Listeners(onError);
    this.identityListeners = new Listeners(onError);
    this.nodeListeners = new Listeners(onError);
    const bearer = (): string | undefined => this.registration.credential; // [AC-13]
    this.programCalls = new ServiceCalls(services, clock, this.#timeoutMs, bearer);
    // Of its own, because `close()` rejects the program's calls but has to know how a registration went.
    const registrationCalls = new ServiceCalls(services, clock, this.#timeoutMs, bearer);
    this.registration = this.#createRegistration(registrationCalls);
    this.profile = new ProfileSync({
      clock,
      registration: this.registration,
      connection: () => this.connection,
    });
    this.calls = new ClientCalls({
      calls: this.programCalls,
      clock,
      timeoutMs: this.#timeoutMs,
      connection: () => this.connection,
      registration: this.registration,
    });
    this.subscriptions = this.#createSubscriptions();
    this.inbox = this.#createInbox();
    this.devices = this.#createDevices();
    this.masterClock = new MasterClock(clock, () => this.connection.link?.measureTime(), onError);
    this.moves = new Moves({
      masters: this.masters,
      registration: this.registration,
      calls: this.programCalls,
      onError,
    });
    this.connection = this.#createConnection(() => registrationCalls.freshen());
    this.#followMasters();
    this.publisher = new Publisher({
      clock,
      masterTime: this.masterClock,
      stampsInMasterTime: options.stampInMasterTime ?? false,
      intervalMs: options.publishIntervalMs ?? DEFAULT_PUBLISH_INTERVAL_MS,
      clientId: () => this.registration.clientId,
      link: () => this.connection.link,
    });
  }

  readonly #handleProblem = (problem: ClientProblem): void => this.problemListeners.emit(problem);

  readonly #handleUnknownClient = (cause: ServiceError): void => {
    this.connection.drop(new ConnectionError('refused', cause.message, { cause }));
  };

  #createRegistration(calls: ServiceCalls): Registration {
    const { identity, name, description, tags, node, joinToken, ...more } = this.#options;
    return new Registration(
      calls,
      reportingStorage(identity ?? createMemoryIdentity(), this.reportError),
      {
        name,
        description: description ?? '',
        tags: tags ?? [],
        node,
        processingModules: more.processingModules ?? [],
        isDedicatedNode: more.isDedicatedNode ?? false,
        mark: more.mark,
      },
      this.#sendTimes,
      joinToken,
    );
  }

  #createSubscriptions(): TopicSubscriptions {
    const { clock, patterns } = this.#ports;
    return new TopicSubscriptions({
      clock,
      patterns,
      callTopicSubscription: (request) => this.calls.callAsMember('topicSubscription', request),
      listTopics: async () => (await this.calls.callNow('topicList', undefined)).elements,
      listComponents: async (profiles) => {
        const elements = profiles.map(profileToMessage);
        return (await this.calls.callNow('componentGetList', { elements })).elements;
      },
      handleProblem: this.#handleProblem,
      handleUnknownClient: this.#handleUnknownClient,
      onError: this.reportError,
    });
  }

  #createInbox(): TopicDataInbox {
    return new TopicDataInbox({
      handleRecord: (record) => this.subscriptions.handleRecord(record),
      handleNodeMessage: (message) => this.nodeListeners.emit(message),
      takesEncoded: () => this.subscriptions.hasEncoded || this.nodeListeners.size > 0,
      handleProblem: this.#handleProblem,
      countAtMaster: (topic) => this.subscriptions.countAtMaster(topic),
    });
  }

  #createDevices(): DeviceRegistry {
    const { clock, uuid } = this.#ports;
    return new DeviceRegistry({
      clock,
      uuid,
      clientId: () => this.registration.clientId,
      registerDevice: (device) => this.calls.callAsMember('deviceRegistration', device),
      deregisterDevice: (device) => this.calls.callAsMember('deviceDeregistration', device),
      endTopic: (topic) => this.publisher.endTopic(topic),
      publish: (topic, format, value, options) =>
        this.publisher.publish(topic, format, value, options),
      subscribe: (topic, options) => this.subscriptions.subscribe({ topic }, options),
      handleProblem: this.#handleProblem,
      handleUnknownClient: this.#handleUnknownClient,
    });
  }

  #createConnection(freshenServices: () => void): Connection {
    const { clock, random } = this.#ports;
    return new Connection({
      clock,
      random,
      policy: this.#policy,
      registration: this.registration,
      transport: this.masters.topicData,
      sendTimes: this.#sendTimes,
      moves: this.moves,
      openTimeoutMs: this.#timeoutMs,
      freshenServices,
      handleBinary: (bytes) => this.inbox.handleBinary(bytes),
      handleUnknownText: (text) => this.inbox.handleUnknownText(text),
      handleRoundTrip: (roundTripMs) => {
        this.roundTripListeners.emit(this.roundTrips.add(roundTripMs));
        if (this.connection.state.status === 'connected') this.profile.sendInBackground();
      },
      time: {
        handleLink: () => this.masterClock.handleLink(),
        handleExchange: (exchange) => this.masterClock.handleExchange(exchange),
        describeClock: () => describeEstimate(this.masterClock.estimate),
      },
      restore: (arrival) => this.#restore(arrival),
      onError: this.reportError,
    });
  }

  get #policy(): ReconnectPolicy {
    return { ...DEFAULT_RECONNECT_POLICY, ...this.#options.reconnect };
  }

  /** Where to go when the master is lost. [CU-80] */
  #followMasters(): void {
    const { connection, masters, registration } = this;
    const { clock, random, uuid } = this.#ports;
    const scout = new Scout({
      clock,
      random,
      masters,
      policy: this.#policy,
      ask: (url) => this.#proofs.ask(masters.at(url), registration.identity, uuid()),
      outage: () => connection.outage,
      recheck: () => connection.recheck(),
      switchTo: (url) => connection.switchTo(url),
    });
    connection.onState((state) => {
      scout.handleState(state);
      if (state.status === 'connected') this.#learnMasters();
    });
  }

  #learnMasters(): void {
    const { membership } = this.registration;
    if (membership === undefined) return;
    // A master that has just started does not know the others yet: keep the earlier list.
    if (membership.masters.length > 0) this.#learn(membership.masters);
    // Clients of a master without a cluster do without the subscription.
    if (!membership.isInCluster || this.#hearsOfMasters) return;
    this.#hearsOfMasters = true;
    this.subscriptions
      .subscribe({ topic: MASTERS_TOPIC }, { format: 'stringList' })
      .onRecord(({ value }) => this.#learn(value.elements));
  }

  #learn(addresses: readonly string[]): void {
    this.masters.learn(addresses);
    if (addresses.length > 0) this.#proofs.load();
  }

  async #restore({ membership, previousId }: Arrival): Promise<void> {
    const { identity, isExtended, serial } = membership;
    this.inbox.handleMaster(isExtended);
    const { clientId } = identity;
    await Promise.all([
      this.devices.resume({ serial, canKeepIds: isExtended }),
      this.subscriptions.resume({ clientId, takesComponents: isExtended }),
    ]);
    if (previousId !== '' && previousId !== clientId) {
      this.identityListeners.emit({ previousId, clientId });
    }
  }
}
