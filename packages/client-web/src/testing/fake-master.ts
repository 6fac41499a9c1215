import { Re2Patterns } from '@ubii/patterns/re2';
import {
  ClientState,
  SERVICES,
  ServiceError,
  decode,
  decodeTopicData,
  encode,
  encodeRecord,
  masterProofText,
  matchesProfile,
} from '@ubii/proto';
import type {
  Client,
  Component,
  Device,
  Init,
  NodeMessage,
  RecordInit,
  ServiceReply,
  ServiceRequest,
  TopicRecord,
  TopicSubscription,
} from '@ubii/proto';
import { encodeRecordListFrame } from '@ubii/proto/wire';
import { proofOf } from '../core/connection/master-proof.ts';
import type { TopicDataQuery } from '../core/ports/topic-data-transport.ts';
import type { MemoryConnection, MemoryMaster, MemoryPeer } from '../transports/memory.ts';

const PATTERNS = new Re2Patterns();

interface FakeClient {
  client: Init<Client>;
  readonly topics: Set<string>;
  readonly regexes: Set<string>;
  /** By their JSON. */
  readonly profiles: Map<string, Component>;
  readonly devices: Map<string, Device>;
}

/**
 * A small master for tests of the client alone: of ours, or an original one. It knows registration,
 * subscriptions, retained records and devices, does what it is told to (stop, restart, drop, keep
 * silent), and remembers what it was sent. Not a model of the real master's limits and refusals.
 */
export class FakeMaster implements MemoryMaster {
  readonly isOriginal: boolean;
  /** Its time, epoch milliseconds; undefined for one that does not tell it. [TS-1] */
  timeMs: (() => number) | undefined;
  /** Every text frame it was sent, in order. */
  readonly texts: string[] = [];
  /** Every service request it was sent, in order. */
  readonly requests: ServiceRequest[] = [];
  /** Every record clients published, in order. */
  readonly published: TopicRecord[] = [];
  /** Every node message it was sent, in order. */
  readonly nodeMessages: NodeMessage[] = [];
  /** Credential that clients receive; undefined for none. [AC-13] */
  credential: string | undefined;
  /** Addresses of the others that clients are told. [CU-26] */
  masters: readonly string[] = [];
  /** Id among the masters of its cluster; empty when it is alone. [CU-70] */
  masterId = '';
  /** Clients that closed a socket with a code of their own, in order. [EX-55] */
  readonly farewells: { readonly clientId: string; readonly code: number }[] = [];
  /** Services beyond its own, by topic. */
  readonly services = new Map<string, (request: ServiceRequest) => Init<ServiceReply>>();
  /** Number of records in each received frame. */
  readonly frameSizes: number[] = [];
  /** While true, the master is down: services fail, sockets do not open. */
  isDown = false;
  /** While true it takes everything and answers nothing. */
  isSilent = false;
  /** Called with every request; a returned or thrown error is the reply. */
  onRequest: ((request: ServiceRequest) => ServiceError | undefined | void) | undefined;
  readonly #clients = new Map<string, FakeClient>();
  readonly #peers = new Map<string, MemoryPeer>();
  readonly #retained = new Map<string, RecordInit>();
  #ids = 0;
  #key = 'key';

  constructor(options: { isOriginal?: boolean; timeMs?: () => number } = {}) {
    this.isOriginal = options.isOriginal ?? false;
    this.timeMs = options.timeMs;
  }

  /** Ids of the registered clients. */
  get clientIds(): string[] {
    return [...this.#clients.keys()];
  }

  /** State that the master stores for a client. */
  holds(clientId: string) {
    const { client, topics, regexes, profiles, devices } = this.#clients.get(clientId)!;
    return {
      name: client.name,
      topics: [...topics].sort(),
      regexes: [...regexes].sort(),
      profiles: [...profiles.keys()].sort(),
      devices: [...devices.values()],
    };
  }

  /** Closes the sockets of all clients, as a broken network does. */
  drop(code = 1006, reason = ''): void {
    for (const [id, peer] of [...this.#peers]) {
      this.#peers.delete(id);
      peer.close(code, reason);
    }
  }

  /** Goes away. */
  stop(): void {
    this.isDown = true;
    this.drop();
  }

  /** Comes back without memory of clients and topics; with another key tokens are worth nothing. */
  restart(options: { hasNewKey?: boolean } = {}): void {
    this.stop();
    this.#clients.clear();
    this.#retained.clear();
    if (options.hasNewKey === true) this.#key += '+';
    this.isDown = false;
  }

  /** Forgets a client without touching its socket. */
  forget(clientId: string): void {
    this.#clients.delete(clientId);
  }

  /** Sends frames as they are to every open socket. */
  sendBytes(bytes: Uint8Array): void {
    for (const peer of this.#peers.values()) peer.sendBinary(bytes);
  }

  sendText(text: string): void {
    for (const peer of this.#peers.values()) peer.sendText(text);
  }

  /** Publishes as the master or another client would. */
  publish(record: RecordInit): void {
    this.#retained.set(record.topic, record);
    for (const [id, client] of this.#clients) {
      const matches = this.#countMatches(client, record.topic);
      // An original master sends one for each subscription that matches.
      const copies = this.isOriginal ? matches : Math.min(1, matches);
      for (let i = 0; i < copies; i++) this.#send(id, [record]);
    }
  }

  async handleServiceRequest(request: ServiceRequest): Promise<Init<ServiceReply>> {
    if (this.isDown) throw new Error('the master is down');
    this.requests.push(request);
    if (this.isSilent) return new Promise(() => undefined);
    try {
      const error = this.onRequest?.(request);
      if (error !== undefined) throw error;
      return this.#answer(request);
    } catch (error) {
      const { code, ...original } = ServiceError.from(error).toWire();
      return { error: this.isOriginal ? original : { ...original, code } };
    }
  }

  openConnection(query: TopicDataQuery, peer: MemoryPeer): MemoryConnection | undefined {
    if (this.isDown) return undefined;
    const { clientId } = query;
    if (!this.isOriginal) {
      if (query.resumeToken !== this.#tokenOf(clientId)) return refuse(peer, 4003);
      if (!this.#clients.has(clientId)) return refuse(peer, 4004);
      this.#peers.get(clientId)?.close(4001, 'superseded');
    }
    this.#peers.set(clientId, peer);
    return {
      handleText: (text) => {
        this.texts.push(text);
        if (this.isSilent || this.isOriginal || !text.startsWith('PING')) return;
        const [, number] = text.split(' ');
        const timeMs = this.timeMs?.();
        peer.sendText(number === undefined ? 'PONG' : `PONG ${number} ${timeMs} ${timeMs}`);
      },
      handleBinary: (bytes) => {
        const { records, nodeMessages } = decodeTopicData(bytes);
        this.nodeMessages.push(...nodeMessages);
        if (records.length > 0) this.frameSizes.push(records.length);
        for (const record of records) {
          if (record.format === undefined) continue;
          this.published.push(record);
          this.publish(record);
        }
      },
      handleClose: (code) => {
        if (this.#peers.get(clientId) !== peer) return;
        this.#peers.delete(clientId);
        if (code === undefined || code < 4000) return;
        this.farewells.push({ clientId, code });
        this.#clients.delete(clientId); // [EX-55]
      },
    };
  }

  #answer(request: ServiceRequest): Init<ServiceReply> {
    switch (request.topic) {
      case SERVICES.clientRegistration.topic:
        return { client: this.#register(request.client!) };
      case SERVICES.clientDeregistration.topic:
        this.#clientOf(request.client!.id);
        this.#clients.delete(request.client!.id);
        return SUCCESS;
      case SERVICES.clientGetList.topic:
        return {
          clientList: { elements: [...this.#clients.values()].map(({ client }) => client) },
        };
      case SERVICES.masterProof.topic: {
        const { targetId: clientId, host, nonce } = request.masterProofRequest!;
        const text = masterProofText({ host, clientId, nonce });
        return { masterProof: { proof: proofOf(this.#tokenOf(clientId), text) } };
      }
      case SERVICES.topicSubscription.topic:
        this.#subscribe(request.topicSubscription!);
        return SUCCESS;
      case SERVICES.deviceRegistration.topic:
        return { device: this.#registerDevice(request.device!) };
      case SERVICES.deviceDeregistration.topic:
        this.#clientOf(request.device!.clientId).devices.delete(request.device!.id);
        return SUCCESS;
      case SERVICES.componentGetList.topic:
        return { componentList: { elements: this.#components() } };
      case SERVICES.topicList.topic:
        return { stringList: { elements: [...this.#retained.keys()] } };
      default: {
        const service = this.services.get(request.topic);
        if (service !== undefined) return service(request);
        throw new ServiceError(
          'unimplemented',
          `The fake master has no service "${request.topic}"`,
        );
      }
    }
  }

  #register(asked: Client): Init<Client> {
    const isResumed =
      !this.isOriginal &&
      asked.id !== '' &&
      asked.extension?.resumeToken === this.#tokenOf(asked.id);
    const id = isResumed ? asked.id : `client-${++this.#ids}`;
    const client: Init<Client> = { id, name: asked.name, state: ClientState.ACTIVE };
    const known = this.#clients.get(id);
    if (known !== undefined) known.client = client;
    else
      this.#clients.set(id, {
        client,
        topics: new Set(),
        regexes: new Set(),
        profiles: new Map(),
        devices: new Map(),
      });
    if (this.isOriginal) return client;
    return {
      ...client,
      extension: {
        resumeToken: this.#tokenOf(id),
        resumed: isResumed,
        masterVersion: '1.2.3',
        tellsTime: this.timeMs !== undefined,
        masters: [...this.masters],
        masterId: this.masterId,
        ...(this.credential !== undefined && { credential: this.credential }),
      },
    };
  }

  #subscribe(asked: TopicSubscription): void {
    const client = this.#clientOf(asked.clientId);
    const added = asked.subscribeTopics.filter((topic) => !client.topics.has(topic));
    for (const topic of added) client.topics.add(topic);
    for (const topic of asked.unsubscribeTopics) client.topics.delete(topic);
    for (const regex of asked.subscribeTopicRegexp) client.regexes.add(regex);
    for (const regex of asked.unsubscribeTopicRegexp) client.regexes.delete(regex);
    if (!this.isOriginal) {
      for (const profile of asked.subscribeComponents)
        client.profiles.set(jsonOf(profile), profile);
      for (const profile of asked.unsubscribeComponents) client.profiles.delete(jsonOf(profile));
    }
    const records = [...this.#retained.values()].filter(({ topic }) => added.includes(topic));
    if (records.length > 0) this.#send(asked.clientId, records);
  }

  #registerDevice(asked: Device): Device {
    const { devices } = this.#clientOf(asked.clientId);
    if (this.isOriginal && asked.id !== '') {
      throw new ServiceError('already_exists', 'The device is registered already');
    }
    const id = asked.id === '' ? `device-${++this.#ids}` : asked.id;
    const components = asked.components.map((component, index) => ({
      ...component,
      deviceId: id,
      id: component.id === '' ? `${id}-${index}` : component.id,
    }));
    const device = { ...asked, id, components };
    devices.set(id, device);
    return device;
  }

  /** Number of subscriptions of a client that match a topic. */
  #countMatches({ topics, regexes, profiles }: FakeClient, topic: string): number {
    const components = this.#components().filter((component) => component.topic === topic);
    const isSelected = (profile: Component): boolean =>
      components.some((component) => matchesProfile(component, profile));
    return (
      (topics.has(topic) ? 1 : 0) +
      [...regexes].filter((source) => PATTERNS.compile(source).test(topic)).length +
      [...profiles.values()].filter(isSelected).length
    );
  }

  #components(): Component[] {
    return [...this.#clients.values()].flatMap(({ devices }) =>
      [...devices.values()].flatMap(({ components }) => components),
    );
  }

  #clientOf(id: string): FakeClient {
    const client = this.#clients.get(id);
    if (client === undefined) throw new ServiceError('not_found', `No client has the id "${id}"`);
    return client;
  }

  #tokenOf(clientId: string): string {
    return `${this.#key}:${clientId}`;
  }

  #send(clientId: string, records: readonly RecordInit[]): void {
    const peer = this.#peers.get(clientId);
    if (peer === undefined) return;
    const encoded = records.map((record) => encodeRecord(record));
    if (!this.isOriginal) {
      peer.sendBinary(encodeRecordListFrame(encoded));
      return;
    }
    for (const bytes of encoded) {
      const topicDataRecord = decode('ubii.topicData.TopicDataRecord', bytes);
      peer.sendBinary(encode('ubii.topicData.TopicData', { topicDataRecord }));
    }
  }
}

const SUCCESS: Init<ServiceReply> = { success: { title: 'Success' } };

function refuse(peer: MemoryPeer, code: number): undefined {
  peer.close(code, '');
  return undefined;
}

function jsonOf(profile: object): string {
  return JSON.stringify(profile);
}
