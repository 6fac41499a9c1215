import { DecodeError, ServiceError, type ServiceErrorCode } from '@ubii/proto';
import { scanTopicData } from '@ubii/proto/wire';
import type { TextCache, TimedPing, TopicDataSink } from '@ubii/proto/wire';
import { TokenBucket, type EndOfTurn, type PreciseClock } from '@ubii/timing';
import type { LimitName } from '../limits/index.ts';
import type { ClientConnection } from '../ports/client-connection.ts';
import type { ClientEnding, CloseReason } from '../ports/close-reason.ts';
import type { ConnectionHandle } from '../ports/connection-handle.ts';
import type { Log } from '../ports/log.ts';
import type { Counters } from '../counters/counters.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { Publication } from '../topics/publication.ts';
import { publish, type PublishContext } from '../topics/publisher.ts';
import type { ClientRegistry } from './client-registry.ts';
import type { ClientSocket } from './client-socket.ts';
import type { Client } from './client.ts';

/** Dependencies of a socket. */
export interface SocketContext extends PublishContext {
  readonly clock: PreciseClock;
  readonly log: Log;
  readonly endOfTurn: EndOfTurn;
  /** Topics that came lately, of all clients. */
  readonly topicTexts: TextCache;
  readonly limitWatch: LimitWatch;
  readonly counters: Counters;
  readonly clients: Pick<ClientRegistry, 'handleSign'>;
  /** A node says something. @throws DecodeError when it cannot be read */
  readonly onNodeMessage: (client: Client, bytes: Uint8Array) => void;
  /** The socket is closed, from whichever side. Not called for one that was superseded. */
  readonly onClosed: (socket: TopicDataSocket, ending: ClientEnding) => void;
}

const NO_BYTES = new Uint8Array(0);

/** The live socket of one client: what comes in on it, and how it ends. */
export class TopicDataSocket implements ClientSocket, ConnectionHandle, TopicDataSink {
  readonly client: Client;
  readonly #context: SocketContext;
  readonly #connection: ClientConnection;
  readonly #publication = new Publication();
  readonly #errorBudget: TokenBucket;
  /** When the latest protocol errors happened, oldest first. */
  #protocolErrorsMs: number[] = [];
  #isOpen = true;
  /** Queue of the connection and bytes handed to it, when it was last seen to take something. */
  #queuedBytes = 0;
  #handedBytes: number;
  #tookSomethingMs: number;

  constructor(context: SocketContext, client: Client, connection: ClientConnection) {
    this.client = client;
    this.#context = context;
    this.#connection = connection;
    this.#publication.client = client;
    const nowMs = context.clock.monotonicMs();
    this.#errorBudget = new TokenBucket(context.limits.errorsPerSecond, nowMs);
    this.#handedBytes = client.subscriber.outbox.handedBytes;
    this.#tookSomethingMs = nowMs;
  }

  get connection(): ClientConnection {
    return this.#connection;
  }

  setRecordLists(on: boolean): void {
    this.#connection.setRecordLists(on);
  }

  handleReadStart(): void {
    this.#context.endOfTurn.beginRead(this);
  }

  handleReadEnd(): void {
    this.#context.endOfTurn.endRead();
  }

  handleTopicData(bytes: Uint8Array): void {
    if (!this.#isOpen) return;
    const { clock, log, limits, topicTexts } = this.#context;
    const publication = this.#publication;
    this.#handleSign();
    if (bytes.byteLength > limits.frameBytes) return this.#refuseFrame(bytes.byteLength);
    publication.frame = bytes;
    publication.monotonicMs = this.client.lastSignMs;
    publication.nowMs = clock.nowMs();
    try {
      scanTopicData(bytes, this, topicTexts);
    } catch (error) {
      if (error instanceof DecodeError)
        this.handleProtocolError(`${error.message}.`); // [TD-12]
      else log.error('a record could not be published', { reason: String(error) });
    } finally {
      publication.frame = NO_BYTES;
      publication.entry = undefined;
    }
  }

  /** [TD-2] [EX-6] */
  handlePing(timed?: TimedPing): void {
    if (!this.#isOpen) return;
    const { clock, limits } = this.#context;
    const receivedMs = timed === undefined ? 0 : clock.preciseMs();
    this.#handleSign();
    if (timed?.clock !== undefined) {
      this.client.clock = { ...timed.clock, toldMs: clock.monotonicMs() }; // [TS-10]
    }
    // A client that sends PINGs without reading the replies gets no further replies.
    if (this.#connection.queuedBytes > limits.connectionQueuedBytes) return;
    if (timed === undefined) this.#connection.sendPong();
    else {
      const { number } = timed;
      this.#connection.sendPong({ number, receivedMs, sentMs: clock.preciseMs() }); // [TS-2]
    }
  }

  handlePong(): void {
    if (!this.#isOpen) return;
    this.#handleSign();
    const { client } = this;
    if (client.pingSentMs === undefined) return;
    const nowMs = this.#context.clock.monotonicMs();
    client.latencyMs = nowMs - client.pingSentMs; // [CL-15]
    client.latencyMeasuredMs = nowMs;
    client.pingSentMs = undefined;
  }

  handleDrain(): void {
    if (this.#isOpen) this.client.subscriber.outbox.handleDrain();
  }

  handleProtocolError(reason: string): void {
    if (!this.#isOpen) return;
    this.#handleSign(); // [CL-11]
    const { counters, limits, limitWatch, clock, log } = this.#context;
    counters.protocolErrors++;
    this.sendError('invalid_argument', reason);
    const nowMs = clock.monotonicMs();
    this.client.protocolErrors.add(nowMs);
    const sinceMs = nowMs - limits.protocolErrorWindowMs;
    this.#protocolErrorsMs.push(nowMs);
    this.#protocolErrorsMs = this.#protocolErrorsMs.filter((atMs) => atMs > sinceMs);
    if (this.#protocolErrorsMs.length <= limits.protocolErrors) return;
    limitWatch.count('protocolErrors', this.client.id);
    log.warn('a socket was closed after too many protocol errors', { clientId: this.client.id });
    this.close('protocol errors'); // [TD-18]
  }

  handleClose(ending: ClientEnding): void {
    if (!this.#isOpen) return;
    this.#isOpen = false;
    this.#context.onClosed(this, ending);
  }

  // --- What scanTopicData finds ---

  record(topic: string, start: number, end: number, valueField: number): void {
    const publication = this.#publication;
    publication.topic = topic;
    publication.start = start;
    publication.end = end;
    publication.valueField = valueField;
    const refusal = publish(this.#context, publication);
    if (refusal === undefined) return;
    // Only what is sent is put into words. [TD-17]
    const { limits } = this.#context;
    const { limit } = refusal;
    this.#refuse(
      refusal.code,
      typeof limit === 'function' ? limit(publication, limits) : limit,
      () => refusal.describe(publication, limits),
    );
  }

  error(): void {
    // Nothing is asked of the master by a client's error.
  }

  nodeMessage(start: number, end: number): void {
    const { frame } = this.#publication;
    if (this.client.node === undefined) {
      this.handleProtocolError('A node message was received from a client that is not a node.'); // [EX-20]
      return;
    }
    this.#context.onNodeMessage(this.client, frame.subarray(start, end));
  }

  // --- What the master does with it ---

  /** Sends a frame of topic data as it is. */
  sendFrame(frame: Uint8Array): void {
    if (this.#isOpen) this.#connection.sendFrame(frame);
  }

  /** Closes the socket from our side. */
  close(reason: CloseReason, explanation?: string): void {
    if (!this.#isOpen) return;
    this.#connection.close(reason, explanation);
    this.handleClose('lost');
  }

  /** Another socket took the place of this one [TD-7]. */
  supersede(): void {
    this.#isOpen = false;
    this.#connection.close('superseded');
  }

  /** Tells the client what went wrong, unless it was told too much lately [TD-17]. */
  sendError(code: ServiceErrorCode, message: string): void {
    if (this.#isOpen && this.#mayTellError()) {
      this.#connection.sendError(new ServiceError(code, message).toWire());
    }
  }

  sendPing(): void {
    if (!this.#isOpen) return;
    this.client.pingSentMs = this.#context.clock.monotonicMs();
    this.#connection.sendPing();
  }

  /** Looks after the queue: sends what can be sent, and gives up a socket that takes nothing [TD-32]. */
  handleSweep(): void {
    const { clock, limits, limitWatch, log } = this.#context;
    const { outbox } = this.client.subscriber;
    outbox.handleDrain();
    const { queuedBytes } = this.#connection;
    const nowMs = clock.monotonicMs();
    // All that was handed over since is in the queue still: nothing was taken.
    const isStuck =
      queuedBytes > 0 && queuedBytes - this.#queuedBytes >= outbox.handedBytes - this.#handedBytes;
    this.#queuedBytes = queuedBytes;
    this.#handedBytes = outbox.handedBytes;
    if (!isStuck) this.#tookSomethingMs = nowMs;
    else if (nowMs - this.#tookSomethingMs >= limits.slowSocketTimeoutMs) {
      limitWatch.count('slowSocketTimeoutMs', this.client.id);
      log.warn('a socket that received nothing was closed', { clientId: this.client.id });
      this.close('too slow');
    }
  }

  #handleSign(): void {
    this.client.heardSequence = this.#context.topics.sequence;
    this.#context.clients.handleSign(this.client);
  }

  #refuseFrame(byteLength: number): void {
    const { frameBytes } = this.#context.limits;
    this.#refuse(
      'resource_exhausted',
      'frameBytes',
      () =>
        `The message has ${byteLength} bytes, but a message has at most ${frameBytes} (limit frameBytes).`,
    );
  }

  #refuse(code: ServiceErrorCode, limit: LimitName | undefined, describe: () => string): void {
    const { counters, limitWatch } = this.#context;
    counters.refused[code]++;
    this.client.traffic.refused++;
    if (limit !== undefined) limitWatch.count(limit, this.client.id);
    if (this.#mayTellError()) {
      this.#connection.sendError(new ServiceError(code, describe()).toWire());
    }
  }

  #mayTellError(): boolean {
    return this.#errorBudget.take(1, this.#context.clock.monotonicMs());
  }
}
