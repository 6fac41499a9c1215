import { decode, encode, isMasterTopic, type Component, type Device } from '@ubii/proto';
import type { ClientAccess } from '../access/caller.ts';
import { hasComponentRights } from '../access/device-rights.ts';
import { namespaceOwner } from '../access/topic-rights.ts';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { Client } from '../clients/client.ts';
import type { SocketAdmission } from '../clients/socket-admission.ts';
import type { DeviceRegistry } from '../devices/device-registry.ts';
import type { InfoTopics } from '../info/info-topics.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { ClientConnection } from '../ports/client-connection.ts';
import type { ConnectionHandle } from '../ports/connection-handle.ts';
import { boundTexts } from '../texts/bound-texts.ts';
import type { TopicTable } from '../topics/topic-table.ts';

/** What a client of a replay works with. */
export interface ReplayClientContext {
  readonly clients: ClientRegistry;
  readonly devices: DeviceRegistry;
  readonly limitWatch: LimitWatch;
  readonly sockets: SocketAdmission;
  readonly info: InfoTopics;
  readonly topics: TopicTable;
}

/** How the client appears. */
export interface ReplayClientSpec {
  readonly name: string;
  readonly access: ClientAccess;
  /** What the master refuses of it. */
  onError(message: string): void;
  /** Its connection was closed by the master. */
  onClosed(reason: string): void;
}

const TAG = 'replay';

/** A client within the process: listed, limited and counted as all others. [RP-1] */
export class ReplayClient {
  readonly client: Client;
  readonly #context: ReplayClientContext;
  readonly #handle: ConnectionHandle;
  #isOpen = true;

  /** @throws ServiceError when there is no room for another client */
  constructor(context: ReplayClientContext, spec: ReplayClientSpec) {
    const { clients, sockets, info } = context;
    this.#context = context;
    const message = { name: spec.name, tags: [TAG], extension: { recordLists: true } };
    const complete = decode('ubii.clients.Client', encode('ubii.clients.Client', message));
    this.client = clients.register(complete, spec.access).client;
    try {
      this.#handle = sockets.attach(this.client, this.#connection(spec));
    } catch (cause) {
      clients.handleEvent(this.client, 'deregistered');
      throw cause;
    }
    info.announceClient(this.client);
  }

  get id(): string {
    return this.client.id;
  }

  mayPublish(topic: string): boolean {
    return this.client.publishRights?.mayPublish(topic) !== false;
  }

  /**
   * Whether its devices may have this component: as those of its starter, and on no topic of the master or of another
   * client, whose records it neither gets nor publishes. [RP-33]
   */
  mayHave(component: Pick<Component, 'topic' | 'ioType'>): boolean {
    const { topic } = component;
    if (isMasterTopic(topic) || !hasComponentRights(this.client, component)) return false;
    const owner = namespaceOwner(topic, this.#context.clients);
    return owner === undefined || owner === this.id;
  }

  /** Registers devices, which end with the client. @throws ServiceError when there is no room for them */
  register(devices: readonly Device[]): void {
    const { devices: registry, info, limitWatch } = this.#context;
    for (const device of devices) registry.register(this.client, boundDevice(device, limitWatch));
    if (devices.length > 0) info.announceClient(this.client); // [CL-31]
  }

  /** Publishes a frame of records. */
  publish(frame: Uint8Array): void {
    this.#handle.handleReadStart();
    this.#handle.handleTopicData(frame);
    this.#handle.handleReadEnd();
  }

  /** Removes the client and all its topics, kept values included. */
  close(): void {
    if (!this.#isOpen) return;
    this.#isOpen = false;
    const { clients, topics } = this.#context;
    for (const entry of [...this.client.ownedTopics]) topics.deleteValue(entry);
    clients.handleEvent(this.client, 'deregistered');
  }

  #connection({ onError, onClosed }: ReplayClientSpec): ClientConnection {
    return {
      queuedBytes: 0,
      send: () => undefined, // It subscribes to nothing.
      sendFrame: () => undefined,
      sendError: ({ message }) => onError(message),
      sendPing: () => this.#handle.handlePong(),
      sendPong: () => undefined,
      setRecordLists: () => undefined,
      close: (reason, explanation) => {
        if (this.#isOpen) onClosed(explanation ?? reason);
      },
    };
  }
}

/** The device as a request could hold it: files may be from other masters, or from unknown programs. */
function boundDevice(device: Device, watch: LimitWatch): Device {
  const type = 'ubii.services.ServiceRequest';
  const request = decode(type, encode(type, { device }));
  const bounded = boundTexts(type, request, {
    limits: watch.limits,
    refuse: ({ limit, length }) =>
      watch.refusal(limit, `a text of length ${length} of a recorded device`),
  });
  return bounded.device!;
}
