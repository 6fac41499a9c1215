import type { Clock } from '@ubii/timing';
import WebSocket from 'ws';
import { BackOff } from '../../core/back-off.ts';
import { WaitingMessages } from '../../core/engine/waiting-messages.ts';
import { forgetFirst } from '../../core/forget-first.ts';
import { BRIDGE_LIMITS } from '../../core/limits.ts';
import { takesIn } from '../../core/mapping/mapping.ts';
import type { Mapping } from '../../core/mapping/mapping.ts';
import type {
  ForeignEvents,
  ForeignSystem,
  OutgoingMessage,
  Sent,
} from '../../core/ports/foreign-system.ts';
import { readFrame } from './read-frame.ts';
import type { RosMessage } from './ros-message.ts';

const HEARTBEAT_MS = 15_000;
const OPEN_TIMEOUT_MS = 10_000;
/** Base64 is a third longer than the bytes. */
const MAX_FRAME_BYTES = Math.ceil((BRIDGE_LIMITS.messageBytes * 4) / 3) + 64 * 1024;
/** Messages that the publisher of rosbridge queues. */
const QUEUE_SIZE = 10;
/** Topics that are advertised at once: rosbridge holds a publisher for each. */
const MAX_ADVERTISED = 1_000;
const NAME = /^[/~A-Za-z][\w/]*$/;

/** Arguments of `createRosbridgeSystem`. */
export interface RosbridgeSettings {
  /** `ws://host:9090` or `wss://host:9090` */
  readonly url: string;
  readonly ca: Buffer | undefined;
  /** For a proxy before rosbridge, which has no users itself (HTTP Basic). [BR-43] */
  readonly user?: string | undefined;
  readonly password?: string | undefined;
  readonly clock: Clock;
  readonly random?: () => number;
}

/** A rosbridge, protocol version 2 (rosbridge_suite, ROSBRIDGE_PROTOCOL.md). */
export function createRosbridgeSystem(settings: RosbridgeSettings): ForeignSystem<RosMessage> {
  return new RosbridgeSystem(settings);
}

class RosbridgeSystem implements ForeignSystem<RosMessage> {
  readonly #settings: RosbridgeSettings;
  readonly #backOff: BackOff;
  readonly #waiting: WaitingMessages<RosMessage>;
  #events: ForeignEvents<RosMessage> | undefined;
  #socket: WebSocket | undefined;
  /** By what they say. */
  #wanted: ReadonlyMap<string, RosSubscription> = new Map();
  /** Topics that are advertised on this connection, with their types. */
  readonly #advertised = new Map<string, string>();
  #isClosed = false;
  #wasConnected = false;
  #isAlive = true;
  #failure = '';
  #timers: (() => void)[] = [];

  constructor(settings: RosbridgeSettings) {
    this.#settings = settings;
    this.#backOff = new BackOff(settings.random ?? Math.random);
    this.#waiting = new WaitingMessages(({ mapping }, reason) =>
      this.#events?.handleDropped(mapping, reason),
    );
  }

  open(events: ForeignEvents<RosMessage>): void {
    this.#events = events;
    events.handleState({ status: 'connecting' });
    this.#connect();
  }

  setMappings(mappings: readonly Mapping[]): void {
    const before = this.#wanted;
    this.#wanted = subscriptionsOf(mappings);
    for (const [text, { id, topic }] of before) {
      if (!this.#wanted.has(text)) this.#tell({ op: 'unsubscribe', id, topic });
    }
    // A subscription that goes on gets no latched message again.
    for (const [text, subscription] of this.#wanted)
      if (!before.has(text)) this.#tell(subscription);
    if (this.#isOpen) this.#events?.handleSettled();
  }

  send(message: OutgoingMessage<RosMessage>): Sent {
    if (this.#isClosed) return { kind: 'dropped', reason: 'The bridge ends.' };
    if (!NAME.test(message.address)) {
      return { kind: 'refused', reason: `${message.address} is no name of ROS.` };
    }
    // ROS keeps messages of a publisher that latches, and has nothing to delete them with.
    if (message.payload === undefined) return { kind: 'sent' };
    if (this.#isOpen) return this.#publish(message);
    if (message.mapping.retained) {
      return this.#waiting.add(message, JSON.stringify(message.payload).length);
    }
    return { kind: 'dropped', reason: 'rosbridge is not connected.' };
  }

  setAvailable(_isAvailable: boolean): void {}

  async close(): Promise<void> {
    this.#events = undefined;
    this.#isClosed = true;
    for (const cancel of this.#timers) cancel();
    const socket = this.#socket;
    if (socket === undefined || socket.readyState === WebSocket.CLOSED) return;
    const closed = new Promise((resolve) => socket.once('close', resolve));
    if (socket.readyState === WebSocket.OPEN) socket.close();
    else socket.terminate();
    await Promise.race([closed, new Promise((resolve) => setTimeout(resolve, 500))]);
    socket.terminate();
  }

  get #isOpen(): boolean {
    return this.#socket?.readyState === WebSocket.OPEN;
  }

  #connect(): void {
    const { url, ca, user, password = '' } = this.#settings;
    const socket = new WebSocket(url, {
      maxPayload: MAX_FRAME_BYTES,
      handshakeTimeout: OPEN_TIMEOUT_MS,
      ...(ca !== undefined && { ca }),
      ...(user !== undefined && { auth: `${user}:${password}` }),
    });
    this.#socket = socket;
    socket.on('open', () => this.#handleOpen());
    socket.on('message', (data, isBinary) => this.#handleFrame(data as Buffer, isBinary));
    socket.on('pong', () => (this.#isAlive = true));
    socket.on('error', (error: NodeJS.ErrnoException) => {
      this.#failure = error.message || String(error.code);
    });
    socket.on('close', () => this.#handleClose());
  }

  #handleOpen(): void {
    const { clock } = this.#settings;
    this.#backOff.handleConnected();
    this.#failure = '';
    this.#isAlive = true;
    this.#advertised.clear();
    this.#timers = [clock.every(HEARTBEAT_MS, () => this.#beat())];
    for (const subscription of this.#wanted.values()) this.#tell(subscription);
    // A publisher that latches ends with its connection, and its messages with it.
    this.#events?.handleState({ status: 'connected', hasForgotten: this.#wasConnected });
    this.#wasConnected = true;
    // rosbridge does not mark latched messages.
    this.#events?.handleSettled();
    for (const message of this.#waiting.takeAll()) {
      const sent = this.#publish(message);
      if ('reason' in sent) this.#events?.handleDropped(message.mapping, sent.reason);
    }
  }

  #handleClose(): void {
    for (const cancel of this.#timers) cancel();
    if (this.#isClosed) return;
    const reason = this.#failure || 'the connection was closed';
    this.#events?.handleState({ status: 'waiting', reason });
    const { clock } = this.#settings;
    this.#timers = [clock.after(this.#backOff.nextMs(), () => this.#connect())];
  }

  /** Closes a connection that does not answer a ping. */
  #beat(): void {
    if (!this.#isAlive) return this.#socket?.terminate();
    this.#isAlive = false;
    this.#socket?.ping();
  }

  #handleFrame(bytes: Buffer, isBinary: boolean): void {
    let frame: Readonly<Record<string, unknown>>;
    try {
      frame = readFrame(bytes, isBinary);
    } catch (error) {
      this.#events?.handleRefused(`No message of rosbridge: ${(error as Error).message}`);
      return;
    }
    const { op, topic, msg } = frame;
    if (op === 'publish' && typeof topic === 'string' && typeof msg === 'object' && msg !== null) {
      this.#events?.handleMessage({
        address: topic,
        payload: msg as RosMessage,
        sizeBytes: bytes.length,
        isEmpty: false,
        isOurs: false,
        isKept: false,
      });
    } else if (op === 'status' && (frame['level'] === 'error' || frame['level'] === 'warning')) {
      this.#events?.handleRefused(`rosbridge: ${String(frame['msg']).slice(0, 500)}`);
    } else if (op !== 'status') {
      this.#events?.handleRefused(
        `Messages of the kind ${String(op).slice(0, 100)} are not taken.`,
      );
    }
  }

  #publish({ address, payload, mapping }: OutgoingMessage<RosMessage>): Sent {
    const bufferedBytes = this.#socket?.bufferedAmount ?? 0;
    if (bufferedBytes > BRIDGE_LIMITS.waitingBytes) {
      return { kind: 'dropped', reason: 'rosbridge takes messages too slowly.' };
    }
    if (this.#advertised.get(address) !== mapping.rosType) {
      const { rosType: type, retained: latch } = mapping;
      this.#advertised.set(address, type);
      const oldest = forgetFirst(this.#advertised, MAX_ADVERTISED);
      if (oldest !== undefined) this.#tell({ op: 'unadvertise', topic: oldest });
      this.#tell({ op: 'advertise', topic: address, type, latch, queue_size: QUEUE_SIZE });
    }
    this.#tell({ op: 'publish', topic: address, msg: payload });
    return { kind: 'sent' };
  }

  #tell(message: object): void {
    if (this.#isOpen) this.#socket?.send(JSON.stringify(message));
  }
}

/** As rosbridge is asked for the messages of a topic. */
interface RosSubscription {
  readonly op: 'subscribe';
  readonly id: string;
  readonly topic: string;
}

function subscriptionsOf(mappings: readonly Mapping[]): ReadonlyMap<string, RosSubscription> {
  const subscriptions = mappings.filter(takesIn).map((mapping) => ({
    ...({ op: 'subscribe', id: `subscribe:${mapping.name}`, topic: mapping.foreign.text } as const),
    type: mapping.rosType,
    // Milliseconds between messages; rosbridge counts whole ones.
    throttle_rate: mapping.maxRateHz > 0 ? Math.floor(1_000 / mapping.maxRateHz) : 0,
    queue_length: mapping.queueLength,
    compression: mapping.compression,
  }));
  return new Map(subscriptions.map((one) => [JSON.stringify(one), one]));
}
