import { ServiceError, type ServiceErrorCode } from '@ubii/proto';
import type { TimedPing } from '@ubii/proto/wire';
import { TokenBucket, type EndOfTurn, type PreciseClock } from '@ubii/timing';
import type { ClientConnection } from '../ports/client-connection.ts';
import type { ClientEnding, CloseReason } from '../ports/close-reason.ts';
import type { ConnectionHandle } from '../ports/connection-handle.ts';
import type { Counters } from '../counters/counters.ts';
import type { Publication } from '../topics/publication.ts';
import type { Refusal } from '../topics/refusals.ts';
import type { ClientRegistry } from './client-registry.ts';
import type { ClientSocket } from './client-socket.ts';
import type { Client } from './client.ts';
import { IncomingFrames, type FrameContext, type FrameOwner } from './incoming-frames.ts';

/** Dependencies of a socket. */
export interface SocketContext extends FrameContext {
  readonly clock: PreciseClock;
  readonly endOfTurn: EndOfTurn;
  readonly counters: Counters;
  readonly clients: Pick<ClientRegistry, 'handleSign'>;
  /** A node says something. @throws DecodeError when it cannot be read */
  readonly onNodeMessage: (client: Client, bytes: Uint8Array) => void;
  /** The socket is closed, from whichever side. Not called for one that was superseded. */
  readonly onClosed: (socket: TopicDataSocket, ending: ClientEnding) => void;
}

/** The live socket of one client: what comes in on it, and how it ends. */
export class TopicDataSocket implements ClientSocket, ConnectionHandle, FrameOwner {
  readonly client: Client;
  readonly #context: SocketContext;
  readonly #connection: ClientConnection;
  readonly #frames: IncomingFrames;
  readonly #errorBudget: TokenBucket;
  /** When the latest protocol errors happened, oldest first. */
  #protocolErrorsMs: number[] = [];
  #isOpen = true;
  /** How its transport ended, while frames that came before are still to be read. */
  #ending: ClientEnding | undefined = undefined;
  /** Queue of the connection and bytes handed to it, when it was last seen to take something. */
  #queuedBytes = 0;
  #handedBytes: number;
  #tookSomethingMs: number;

  constructor(context: SocketContext, client: Client, connection: ClientConnection) {
    this.client = client;
    this.#context = context;
    this.#connection = connection;
    this.#frames = new IncomingFrames(context, this);
    const nowMs = context.clock.monotonicMs();
    this.#errorBudget = new TokenBucket(context.limits.errorsPerSecond, nowMs);
    this.#handedBytes = client.subscriber.outbox.handedBytes;
    this.#tookSomethingMs = nowMs;
  }

  get isOpen(): boolean {
    return this.#isOpen;
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
    if (this.#isOpen) this.#handleSign();
    this.#frames.handleFrame(bytes);
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
    if (this.#frames.hasUnread) this.#ending ??= ending;
    else this.#end(ending);
  }

  // --- What its frames bring ---

  handleNodeMessage(bytes: Uint8Array): void {
    if (this.client.node === undefined) {
      this.handleProtocolError('A node message was received from a client that is not a node.'); // [EX-20]
      return;
    }
    this.#context.onNodeMessage(this.client, bytes);
  }

  handleRefused(refusal: Refusal, publication: Publication): void {
    const { limits, limitWatch } = this.#context;
    const { code, limit } = refusal;
    this.handleRestRefused(refusal, 1);
    const name = typeof limit === 'function' ? limit(publication, limits) : limit;
    if (name !== undefined) limitWatch.count(name, this.client.id);
    // Only what is sent is put into words. [TD-17]
    if (this.#mayTellError()) {
      const message = refusal.describe(publication, limits);
      this.#connection.sendError(new ServiceError(code, message).toWire());
    }
  }

  handleRestRefused({ code }: Refusal, count: number): void {
    this.#context.counters.refused[code] += count;
    this.client.traffic.refused += count;
  }

  handleAllRead(): void {
    if (this.#ending !== undefined) this.#end(this.#ending);
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
    this.#end('lost');
  }

  /** Another socket took the place of this one [TD-7]. */
  supersede(): void {
    this.#isOpen = false;
    this.#connection.close('superseded');
    this.#frames.discard();
  }

  /** Sends the client an error, within a rate limit [TD-17]. */
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

  /** Serves the queue: sends what can be sent, and closes a socket that takes nothing [TD-32]. */
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

  #end(ending: ClientEnding): void {
    if (!this.#isOpen) return;
    this.#isOpen = false;
    this.#frames.discard();
    this.#context.onClosed(this, ending);
  }

  #mayTellError(): boolean {
    return this.#errorBudget.take(1, this.#context.clock.monotonicMs());
  }
}
