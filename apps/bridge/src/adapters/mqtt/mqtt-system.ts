import { Socket } from 'node:net';
import { connect } from 'mqtt';
import type { IClientOptions, IConnackPacket, IPublishPacket, MqttClient } from 'mqtt';
import { BackOff } from '../../core/back-off.ts';
import { WaitingMessages } from '../../core/engine/waiting-messages.ts';
import { BRIDGE_LIMITS } from '../../core/limits.ts';
import type { Mapping } from '../../core/mapping/mapping.ts';
import type {
  ForeignEvents,
  ForeignSystem,
  OutgoingMessage,
  Sent,
} from '../../core/ports/foreign-system.ts';
import { filtersOf } from './subscriptions.ts';
import type { FilterOptions } from './subscriptions.ts';

/** User property that says which master a message came from. [BR-21] */
const ORIGIN = 'ubii-master';
/** How long the broker keeps the session while the bridge is away, seconds. [BR-42] */
const SESSION_SECONDS = 3_600;
const KEEP_ALIVE_SECONDS = 15;
const CONNECT_TIMEOUT_MS = 10_000;
/** For the topic and the properties beside the payload. */
const PACKET_HEAD_BYTES = 64 * 1024;
const CLOSE_TIMEOUT_MS = 500;

/** Arguments of `createMqttSystem`. */
export interface MqttSettings {
  /** `mqtt://host:port` or `mqtts://host:port`, without user and password. */
  readonly url: string;
  readonly clientId: string;
  readonly user: string | undefined;
  readonly password: string | undefined;
  /** Certificate authority in PEM, in place of those of the system. */
  readonly ca: Buffer | undefined;
  /** Topic at which the bridge says `online` or `offline`. [BR-41] */
  readonly availability: string;
  /** Id of the master, which stays the same while it runs. */
  masterId(): string;
  /** Whether an id is that of another master of its cluster, at which a bridge to this broker is, or was. [BR-21] */
  isMasterOfCluster?(id: string): boolean;
  readonly random?: () => number;
}

/** An MQTT broker, version 5. */
export function createMqttSystem(settings: MqttSettings): ForeignSystem<Uint8Array> {
  return new MqttSystem(settings);
}

class MqttSystem implements ForeignSystem<Uint8Array> {
  readonly #settings: MqttSettings;
  readonly #backOff: BackOff;
  readonly #waiting: WaitingMessages<Uint8Array>;
  #events: ForeignEvents<Uint8Array> | undefined;
  #client: MqttClient | undefined;
  #wanted: ReadonlyMap<string, FilterOptions> = new Map();
  /** Bytes of messages that the broker has not acknowledged. */
  #unacknowledgedBytes = 0;
  /** Number of this connection, of messages that the broker had kept, and of what `#settle` asked for. */
  #connection = 0;
  #keptCount = 0;
  #round = 0;
  #isAvailable = false;
  #isClosed = false;
  #failure = '';

  constructor(settings: MqttSettings) {
    this.#settings = settings;
    this.#backOff = new BackOff(settings.random ?? Math.random);
    this.#waiting = new WaitingMessages(({ mapping }, reason) =>
      this.#events?.handleDropped(mapping, reason),
    );
  }

  open(events: ForeignEvents<Uint8Array>): void {
    this.#events = events;
    events.handleState({ status: 'connecting' });
    const client = connect(this.#settings.url, this.#options());
    this.#client = client;
    client.on('connect', (packet) => this.#handleConnect(client, packet));
    client.on('message', (address, payload, packet) =>
      this.#handleMessage(address, payload, packet),
    );
    client.on('error', (error) => {
      this.#failure = describe(error);
    });
    client.on('close', () => this.#handleClose(client));
  }

  setMappings(mappings: readonly Mapping[]): void {
    const before = this.#wanted;
    this.#wanted = filtersOf(mappings);
    const client = this.#client;
    if (client?.connected !== true) return;
    const gone = [...before.keys()].filter((filter) => !this.#wanted.has(filter));
    if (gone.length > 0) client.unsubscribe(gone);
    this.#subscribe(
      client,
      [...this.#wanted].filter(([filter, options]) => !isSame(before.get(filter), options)),
      () => this.#settle(client),
    );
  }

  send(message: OutgoingMessage<Uint8Array>): Sent {
    if (this.#isClosed) return { kind: 'dropped', reason: 'The bridge ends.' };
    const client = this.#client;
    const sizeBytes = message.payload?.byteLength ?? 0;
    if (client?.connected === true) return this.#publish(client, message, sizeBytes);
    const { qos, retained } = message.mapping;
    if (qos > 0 || retained) return this.#waiting.add(message, sizeBytes);
    return { kind: 'dropped', reason: 'The broker is not connected.' };
  }

  setAvailable(isAvailable: boolean): void {
    this.#isAvailable = isAvailable;
    const client = this.#client;
    if (client?.connected === true) this.#publishAvailability(client);
  }

  async close(): Promise<void> {
    const client = this.#client;
    this.#events = undefined;
    this.#isClosed = true;
    if (client === undefined) return;
    if (client.connected) {
      this.#isAvailable = false;
      const published = new Promise((resolve) => this.#publishAvailability(client, resolve));
      await Promise.race([
        published,
        new Promise((resolve) => setTimeout(resolve, CLOSE_TIMEOUT_MS)),
      ]);
    }
    // The session ends with the program: its next run asks for what it needs then. [BR-42]
    await client
      .endAsync(!client.connected, { properties: { sessionExpiryInterval: 0 } })
      .catch(() => undefined);
  }

  #options(): IClientOptions {
    const { clientId, user, password, ca, availability } = this.#settings;
    return {
      protocolVersion: 5,
      clientId,
      resubscribe: false,
      keepalive: KEEP_ALIVE_SECONDS,
      connectTimeout: CONNECT_TIMEOUT_MS,
      // What an earlier run left there is not wanted; later connections of this run continue its session.
      clean: true,
      // A broker that refuses once, because it is busy or its logins are, may take the next attempt.
      reconnectOnConnackError: true,
      reconnectPeriod: this.#backOff.nextMs(),
      ...(user !== undefined && { username: user }),
      ...(password !== undefined && { password }),
      ...(ca !== undefined && { ca }),
      will: { topic: availability, payload: Buffer.from('offline'), qos: 1, retain: true },
      properties: {
        sessionExpiryInterval: SESSION_SECONDS,
        maximumPacketSize: BRIDGE_LIMITS.messageBytes + PACKET_HEAD_BYTES,
      },
    };
  }

  #handleConnect(client: MqttClient, { sessionPresent }: IConnackPacket): void {
    client.options.clean = false;
    this.#connection++;
    // A small message does not wait for the acknowledgement of the one before it.
    if (client.stream instanceof Socket) client.stream.setNoDelay(true);
    const hasForgotten = this.#connection > 1 && !sessionPresent;
    this.#backOff.handleConnected();
    this.#failure = '';
    this.#publishAvailability(client);
    // Connected only with the subscriptions acknowledged.
    this.#subscribe(client, [...this.#wanted], () => {
      if (!client.connected) return;
      this.#events?.handleState({ status: 'connected', hasForgotten });
      this.#settle(client);
    });
    for (const message of this.#waiting.takeAll()) {
      const sent = this.#publish(client, message, message.payload?.byteLength ?? 0);
      if ('reason' in sent) this.#events?.handleDropped(message.mapping, sent.reason);
    }
  }

  #handleClose(client: MqttClient): void {
    client.options.reconnectPeriod = this.#backOff.nextMs();
    const reason = this.#failure || 'the connection was closed';
    this.#events?.handleState({ status: 'waiting', reason });
  }

  /**
   * Tells when the kept messages of the subscriptions have come. Brokers send them after the acknowledgement, and only some at
   * once: it asks for an answer again, as long as some came before it. [BR-14]
   */
  #settle(client: MqttClient): void {
    const [connection, kept] = [this.#connection, this.#keptCount];
    const round = ++this.#round;
    // Nothing was subscribed there: the answer is all that comes of it.
    client.unsubscribe(`ubii/${this.#settings.clientId}/settled`, () => {
      const isOver = !client.connected || connection !== this.#connection || round !== this.#round;
      if (isOver) return;
      if (kept === this.#keptCount) this.#events?.handleSettled();
      else this.#settle(client);
    });
  }

  #handleMessage(address: string, payload: Buffer, { properties, retain }: IPublishPacket): void {
    if (retain) this.#keptCount++;
    const origin = properties?.userProperties?.[ORIGIN];
    this.#events?.handleMessage({
      address,
      payload,
      sizeBytes: payload.byteLength,
      isEmpty: payload.byteLength === 0,
      isKept: retain,
      isOurs: typeof origin === 'string' && this.#isOurs(origin),
    });
  }

  #isOurs(origin: string): boolean {
    const { masterId, isMasterOfCluster } = this.#settings;
    return origin === masterId() || isMasterOfCluster?.(origin) === true;
  }

  #subscribe(
    client: MqttClient,
    filters: readonly (readonly [string, FilterOptions])[],
    done: () => void = () => undefined,
  ): void {
    if (filters.length === 0) return done();
    client.subscribe(Object.fromEntries(filters), (error, _granted, packet) => {
      if (error) this.#events?.handleRefused(`The broker refused a subscription: ${error.message}`);
      const codes = (packet?.granted ?? []) as readonly number[];
      for (const [index, code] of codes.entries()) {
        if (code < 0x80) continue;
        this.#events?.handleRefused(`The broker refused a subscription to ${filters[index]?.[0]}.`);
      }
      done();
    });
  }

  #publish(client: MqttClient, message: OutgoingMessage<Uint8Array>, sizeBytes: number): Sent {
    const { address, payload, mapping } = message;
    const { qos, retained } = mapping;
    const queuedBytes = this.#unacknowledgedBytes + client.stream.writableLength;
    if (queuedBytes + sizeBytes > BRIDGE_LIMITS.waitingBytes) {
      return { kind: 'dropped', reason: 'The broker takes messages too slowly.' };
    }
    if (qos > 0) this.#unacknowledgedBytes += sizeBytes;
    client.publish(
      address,
      payload === undefined
        ? Buffer.alloc(0)
        : Buffer.from(payload.buffer, payload.byteOffset, payload.byteLength),
      {
        qos,
        retain: retained,
        properties: { userProperties: { [ORIGIN]: this.#settings.masterId() } },
      },
      (error) => {
        if (qos > 0) this.#unacknowledgedBytes -= sizeBytes;
        if (error) this.#events?.handleDropped(mapping, error.message);
      },
    );
    return { kind: 'sent' };
  }

  #publishAvailability(client: MqttClient, done?: (value: unknown) => void): void {
    client.publish(
      this.#settings.availability,
      this.#isAvailable ? 'online' : 'offline',
      { qos: 1, retain: true },
      done,
    );
  }
}

function isSame(before: FilterOptions | undefined, now: FilterOptions): boolean {
  return before?.qos === now.qos && before.rh === now.rh;
}

/** Describes an error of the connection for users, never with the password. */
function describe(error: Error): string {
  const { code } = error as { readonly code?: number | string };
  if (code === 0x84 || code === 1) return 'the broker does not speak MQTT 5';
  if (code === 0x86 || code === 4) return 'the broker refused user or password';
  if (code === 0x87 || code === 5) return 'the broker does not let this user connect';
  return error.message || String(code ?? error.name);
}
