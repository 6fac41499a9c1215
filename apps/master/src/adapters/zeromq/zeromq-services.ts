import { Readable } from 'node:stream';
import type { Socket } from 'node:net';
import type { Clock } from '@ubii/timing';
import { ServiceError } from '@ubii/proto';
import { answerCommand, answersOn } from './answer-command.ts';
import { ByteSource, SourceEnded } from './byte-source.ts';
import { takeFrameHeader } from './read-frame.ts';
import { DELIMITER, MORE, ZmtpError, encodeFrame } from './zmtp-frames.ts';
import type { CallerFacts, Log } from '../../core/ports/index.ts';
import type { CallerReader } from '../access/caller-reader.ts';
import type { ConnectionGuard } from '../network/connection-guard.ts';
import { answerRequest, type AnswerContext } from '../services/answer-request.ts';
import { drain } from '../services/bodies/drain.ts';
import { binaryFormat, jsonFormat } from '../services/service-format.ts';
import { greetPeer } from './greet-peer.ts';
import { OpenSockets } from './open-sockets.ts';

/** Frames that may stand in front of a request, for who passes requests on. */
const MAX_ENVELOPE_FRAMES = 8;
/** Most bytes of each, and of a command. */
const MAX_SMALL_FRAME_BYTES = 255;
/** So much of a body is taken at once, bytes. */
const PIECE_BYTES = 64 * 1024;

/** A request of which all has come but its body. */
interface ServiceMessage {
  /** Encoded frames that stood in front of it, and stand in front of the reply. */
  readonly envelope: readonly Buffer[];
  /** Bytes of the body. */
  readonly size: number;
  /** It has more than one frame, which no request has. */
  readonly hasMore: boolean;
  openBody(): RequestBody;
}

/**
 * Takes a message up to its body: the frames of its envelope, which ends with an empty one. [SV-61]
 *
 * @param answer sends a frame of the protocol itself
 * @throws ZmtpError when it is none, SourceEnded
 */
async function takeRequest(
  source: ByteSource,
  answer: (frame: Buffer) => void,
): Promise<ServiceMessage> {
  const envelope: Buffer[] = [];
  for (;;) {
    const { isCommand, hasMore, bodyBytes } = await takeFrameHeader(source, Infinity);
    const isEnvelope = hasMore && envelope.at(-1) !== DELIMITER;
    if (!isCommand && !isEnvelope) {
      return {
        envelope,
        hasMore,
        size: bodyBytes,
        openBody: () => new RequestBody(source, bodyBytes),
      };
    }
    if (bodyBytes > MAX_SMALL_FRAME_BYTES) throw new ZmtpError('An envelope is too long.');
    const body = await source.take(bodyBytes);
    if (isCommand) {
      const answered = answerCommand(body);
      if (answered !== undefined) answer(answered);
    } else {
      envelope.push(bodyBytes === 0 ? DELIMITER : encodeFrame(body, MORE));
      if (envelope.length > MAX_ENVELOPE_FRAMES) throw new ZmtpError('An envelope is too long.');
    }
  }
}

/** The reply to a request, encoded. */
export function encodeReply({ envelope }: ServiceMessage, reply: Uint8Array): readonly Buffer[] {
  return [...envelope, encodeFrame(reply)];
}

/** Body of a request, read from the socket as it is asked for. */
class RequestBody {
  readonly stream: Readable;
  #left: number;

  constructor(source: ByteSource, size: number) {
    this.#left = size;
    this.stream = Readable.from(this.#pieces(source), { objectMode: false });
  }

  /** Nothing of it is left on the socket. */
  get isRead(): boolean {
    return this.#left === 0;
  }

  async *#pieces(source: ByteSource): AsyncGenerator<Buffer> {
    while (this.#left > 0) {
      const piece = await source.takeSome(Math.min(this.#left, PIECE_BYTES));
      this.#left -= piece.length;
      yield piece;
    }
  }
}

/** Time in which the other side has to end a connection that was ended here, milliseconds. */
const END_MS = 5_000;

/** The first byte of a request as JSON. A request as protobuf cannot begin with it. */
const OPENING_BRACE = 0x7b;

export interface ZeroMqServicesContext extends AnswerContext {
  readonly callers: Pick<CallerReader, 'prepare' | 'read'>;
  readonly log: Log;
  readonly clock: Clock;
  readonly connectionGuard: Pick<ConnectionGuard, 'of'>;
  /** Time for the handshake of a caller, milliseconds. */
  readonly greetingMs: number;
  /** By then a reply was taken, milliseconds. */
  readonly replyMs: number;
}

/**
 * Services as a REP of ZeroMQ. Each caller has its own turn: a slow request does not delay other callers. Requests of one caller
 * are answered one after another. [SV-60]
 */
export class ZeroMqServices {
  readonly #context: ZeroMqServicesContext;
  readonly #sockets = new OpenSockets();
  /** Those that wait for a request. */
  readonly #idle = new Set<Socket>();
  #isClosing = false;

  constructor(context: ZeroMqServicesContext) {
    this.#context = context;
  }

  /** To be called for the `connection` event of a server. */
  handleConnection(socket: Socket): void {
    this.#sockets.add(socket);
    this.#serve(socket).catch((error: unknown) => {
      if (!(error instanceof SourceEnded)) {
        this.#context.log.debug('a ZeroMQ connection failed', { reason: String(error) });
      }
      socket.destroy();
    });
  }

  /** Ends the connections that have no request; the others end with their reply. */
  close(): void {
    this.#isClosing = true;
    for (const socket of this.#idle) socket.destroy();
  }

  /** Ends what is still open silently. */
  terminate(): void {
    this.#sockets.destroyAll();
  }

  async #serve(socket: Socket): Promise<void> {
    const { callers, clock, greetingMs } = this.#context;
    // First of all: the address of a closed socket is unknown.
    const prepared = callers.prepare({ headers: {}, socket });
    const source = new ByteSource(socket);
    const cancel = clock.after(greetingMs, () => socket.destroy());
    const peer = await greetPeer(socket, source, {
      own: 'REP',
      accepted: ['REQ', 'DEALER'],
    }).finally(cancel);
    await prepared;
    if (socket.destroyed) return;
    const caller = callers.read({ headers: {}, socket });
    socket.write(peer.acceptance);
    let goesOn = true;
    while (goesOn && !this.#isClosing) {
      this.#idle.add(socket);
      const message = await takeRequest(source, answersOn(socket)).finally(() =>
        this.#idle.delete(socket),
      );
      goesOn = await this.#answer(socket, source, caller, message);
    }
    source.release();
    if (!this.#isClosing) await drain(socket, clock); // [SV-45]
    socket.end();
    // A peer that does not close its side must not keep the connection.
    socket.once(
      'close',
      clock.after(END_MS, () => socket.destroy()),
    );
  }

  /** @returns whether further requests can be read */
  async #answer(
    socket: Socket,
    source: ByteSource,
    caller: CallerFacts,
    message: ServiceMessage,
  ): Promise<boolean> {
    const { connectionGuard, master } = this.#context;
    connectionGuard.of(socket)?.handleRequest();
    const isJson = message.size > 0 && (await source.peek(1))[0] === OPENING_BRACE;
    const format = isJson ? jsonFormat : binaryFormat;
    const body = message.openBody();
    const answer = message.hasMore
      ? master.refuseServiceRequest(
          new ServiceError('invalid_argument', 'A request is one frame. Send it as one.'),
        )
      : await answerRequest(
          {
            caller,
            connection: socket,
            format,
            body: body.stream,
            declaredBytes: message.size,
            onIdentified: (kind) => connectionGuard.of(socket)?.handleCaller(kind),
          },
          this.#context,
        );
    await this.#reply(socket, encodeReply(message, Buffer.from(format.encodeReply(answer.reply))));
    // Actions that wait for the reply run after it was sent, or after its receiver disconnected. [TD-24]
    answer.afterReply();
    return body.isRead && !message.hasMore && !socket.destroyed;
  }

  /** Settles when the system took the reply, or the connection ended. */
  #reply(socket: Socket, reply: readonly Buffer[]): Promise<void> {
    const { clock, replyMs } = this.#context;
    if (socket.destroyed) return Promise.resolve();
    return new Promise((resolve) => {
      const cancel = clock.after(replyMs, () => socket.destroy());
      const done = (): void => {
        cancel();
        socket.off('close', done);
        resolve();
      };
      socket.on('close', done);
      socket.write(Buffer.concat(reply), done);
    });
  }
}
