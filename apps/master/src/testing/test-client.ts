import {
  decodeRecord,
  encode,
  encodeRecord,
  type Client,
  type DataFormat,
  type DataFormatValues,
  type EmptyRecord,
  type ErrorMessage,
  type Init,
  type RecordInit,
  type ServiceReply,
  type ServiceRequest,
  type TopicRecord,
  type TopicSubscription,
} from '@ubii/proto';
import type { FakeClock } from '@ubii/timing/testing';
import { handleText } from '../adapters/heartbeat/handle-text.ts';
import { DEFAULT_LIMITS } from '../core/limits/index.ts';
import type { Master } from '../core/master/master.ts';
import { TRUSTED_CALLER, type CallerFacts } from '../core/ports/caller-facts.ts';
import type { ConnectionHandle } from '../core/ports/connection-handle.ts';
import type { ClientEnding, CloseReason } from '../core/ports/close-reason.ts';
import type { ConnectionPeer } from '../core/ports/connection-facts.ts';
import { RecordingConnection, type Sent } from './recording-connection.ts';

/** The master of a test, and the clock that ends its turns. */
interface MasterOfClient {
  readonly master: Pick<Master, 'openConnection'>;
  readonly clock: Pick<FakeClock, 'advanceSync' | 'endTurnSync'>;
  call(request: Init<ServiceRequest>, caller: CallerFacts): Promise<ServiceReply>;
}

/** A client in the same process as its master, without anything between them. */
export class TestClient {
  readonly name: string;
  readonly #testMaster: MasterOfClient;
  readonly #caller: CallerFacts;
  /** The client as registered by the master. */
  registered: Client;
  connection: RecordingConnection = new RecordingConnection();
  #handle: ConnectionHandle | undefined = undefined;

  /** @param caller as the transport identifies it before it joins */
  constructor(
    testMaster: MasterOfClient,
    name: string,
    registered: Client,
    caller: CallerFacts = TRUSTED_CALLER,
  ) {
    this.#testMaster = testMaster;
    this.#caller = caller;
    this.name = name;
    this.registered = registered;
  }

  get id(): string {
    return this.registered.id;
  }

  get token(): string | undefined {
    return this.registered.extension?.resumeToken;
  }

  /** Caller facts of its transport, with its credential if it has one. */
  get caller(): CallerFacts {
    const { credential } = this.registered.extension ?? {};
    return { ...this.#caller, bearer: credential || undefined };
  }

  /** The live handle of its socket. */
  get socket(): ConnectionHandle {
    if (this.#handle === undefined) throw new Error(`${this.name} has no socket`);
    return this.#handle;
  }

  /** Opens a socket; the one before, if any, is left as it is. Returns whether the master took it. */
  open(token = this.token, peer?: ConnectionPeer): boolean {
    this.connection = new RecordingConnection();
    this.#handle = this.#testMaster.master.openConnection(
      { clientId: this.id, token },
      this.connection,
      this.caller,
      peer,
    );
    this.#testMaster.clock.endTurnSync();
    return this.#handle !== undefined;
  }

  /** Its network goes away, or it leaves: the socket closes, and the turn ends. */
  drop(ending: ClientEnding = 'lost'): void {
    this.socket.handleClose(ending);
    this.#testMaster.clock.endTurnSync();
  }

  /** Calls a service as this client; the reply leaves, and the turn ends. */
  call(request: Init<ServiceRequest>): Promise<ServiceReply> {
    return this.#testMaster.call(request, this.caller);
  }

  /** Subscribes and unsubscribes, and waits for what it has to receive. @throws Error with the master's message when it refuses. */
  async subscribe(subscription: Init<TopicSubscription>): Promise<void> {
    const { error } = await this.call({
      topic: '/services/topic_subscription',
      topicSubscription: { clientId: this.id, ...subscription },
    });
    if (error) throw new Error(`${error.code}: ${error.message}`);
    if (this.registered.extension === undefined) {
      this.#testMaster.clock.advanceSync(DEFAULT_LIMITS.replayDelayMs);
    }
  }

  /** Publishes one record in a message of its own; the turn goes on. */
  send<F extends DataFormat>(topic: string, format: F, value: DataFormatValues[F]): void {
    this.sendRecords(encodeRecord({ topic, format, value } as RecordInit));
  }

  /** Publishes encoded records: one as it is, several as a list; the turn goes on. */
  sendRecords(...records: Uint8Array[]): void {
    this.socket.handleTopicData(frameOf(records));
  }

  /** Sends a text: a heartbeat, or what is none; the turn goes on. */
  sendText(text: string): void {
    handleText(this.socket, text);
  }

  /** Publishes one record, and the turn ends. */
  publish<F extends DataFormat>(topic: string, format: F, value: DataFormatValues[F]): void {
    this.send(topic, format, value);
    this.#testMaster.clock.endTurnSync();
  }

  /** Returns the frames sent to its socket since the last call. */
  takeSent(): Sent[] {
    return this.connection.sent.splice(0);
  }

  /** The records among what was sent since it was asked last. */
  takeRecords(): (TopicRecord | EmptyRecord)[] {
    return this.takeSent().flatMap((sent) => {
      if (sent.kind === 'record') return [decodeRecord(sent.record)];
      return sent.kind === 'list' ? sent.records.map((record) => decodeRecord(record)) : [];
    });
  }

  /** The records of `takeRecords` as `[topic, value]`. */
  takeValues(): [topic: string, value: unknown][] {
    return this.takeRecords().map(({ topic, value }) => [topic, value]);
  }

  /** The errors among what was sent since it was asked last. */
  takeErrors(): ErrorMessage[] {
    return this.takeSent().flatMap((sent) => (sent.kind === 'error' ? [sent.error] : []));
  }

  /** Why its socket was closed by the master, if it was. */
  get closed(): { reason: CloseReason; explanation?: string } | undefined {
    const last = this.connection.sent.findLast((sent) => sent.kind === 'close');
    if (last === undefined) return undefined;
    const { kind: _, ...closed } = last;
    return closed;
  }
}

/** A frame of the topic-data channel with these encoded records. */
export function frameOf(records: readonly Uint8Array[]): Uint8Array {
  const parts = records.map((record) => [...lengthDelimited(1, record)]);
  const [only] = records;
  if (records.length === 1 && only !== undefined) return Uint8Array.from(lengthDelimited(2, only));
  return Uint8Array.from(lengthDelimited(3, Uint8Array.from(parts.flat())));
}

function lengthDelimited(fieldNumber: number, bytes: Uint8Array): number[] {
  const prefix = [(fieldNumber << 3) | 2];
  let rest = bytes.byteLength;
  while (rest >= 0x80) {
    prefix.push((rest & 0x7f) | 0x80);
    rest >>>= 7;
  }
  return [...prefix, rest, ...bytes];
}

/** An encoded record with a topic and no value. */
export function emptyRecord(topic: string): Uint8Array {
  return encode('ubii.topicData.TopicDataRecord', { topic });
}
