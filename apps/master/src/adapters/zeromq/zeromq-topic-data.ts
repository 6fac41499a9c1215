import type { Socket } from 'node:net';
import type { Clock } from '@ubii/timing';

import type { ClientClaim, ConnectionHandle, ConnectionHost, Log } from '../../core/ports/index.ts';
import type { CallerReader } from '../access/caller-reader.ts';
import { kindOfPeer } from '../addresses/address-kinds.ts';
import type { ConnectionGuard } from '../network/connection-guard.ts';
import { answersOn } from './answer-command.ts';
import { ByteSource } from './byte-source.ts';
import { greetPeer } from './greet-peer.ts';
import { MessageReader } from './message-reader.ts';
import { OpenSockets } from './open-sockets.ts';
import { ZeroMqConnection } from './zeromq-connection.ts';
import { ZmtpError } from './zmtp-frames.ts';

/** Time for a client to take what was sent before its connection ends, milliseconds. */
const CLOSE_TIMEOUT_MS = 5_000;
/** Most that is still read from a connection that is about to end, bytes. */
const MAX_DISCARDED_BYTES = 64 * 1024;
/** Default of `holdMs`. */
const HOLD_MS = 10_000;

export interface ZeroMqTopicDataContext {
  readonly master: ConnectionHost;
  readonly callers: Pick<CallerReader, 'prepare' | 'read'>;
  readonly log: Log;
  readonly clock: Pick<Clock, 'after'>;
  /** Knows the connections of sockets. */
  readonly connectionGuard?: Pick<ConnectionGuard, 'of'>;
  /** Largest message a client may send. */
  readonly maxMessageBytes: number;
  /** Time for the handshake of a client, milliseconds. */
  readonly greetingMs: number;
  /**
   * For how long a client that is not wanted is kept waiting, milliseconds: libraries connect again by themselves, 10
   * times a second. [TD-52]
   */
  readonly holdMs?: number;
}

/** Topic data as a ROUTER of ZeroMQ, to which each client connects with a DEALER. [TD-50] */
export class ZeroMqTopicData {
  readonly #context: ZeroMqTopicDataContext;
  readonly #sockets = new OpenSockets();
  /** Sockets from which nothing more is read. */
  readonly #ending = new WeakSet<Socket>();

  constructor(context: ZeroMqTopicDataContext) {
    this.#context = context;
  }

  /** To be called for the `connection` event of a server. */
  handleConnection(socket: Socket): void {
    this.#sockets.add(socket);
    this.#open(socket).catch((error: unknown) => {
      this.#context.log.debug('a ZeroMQ connection failed', { reason: String(error) });
      // A refusal may still be on its way.
      if (socket.writableEnded) this.#cutLater(socket, CLOSE_TIMEOUT_MS);
      else socket.destroy();
    });
  }

  /** Ends what is still open silently. */
  terminate(): void {
    this.#sockets.destroyAll();
  }

  async #open(socket: Socket): Promise<void> {
    const { master, callers, clock, greetingMs, connectionGuard } = this.#context;
    // First of all: the address of a closed socket is unknown.
    const prepared = callers.prepare({ headers: {}, socket });
    const addressKind = kindOfPeer(socket.remoteAddress);
    const source = new ByteSource(socket);
    const cancel = clock.after(greetingMs, () => socket.destroy());
    const peer = await greetPeer(socket, source, { own: 'ROUTER', accepted: ['DEALER'] }).finally(
      cancel,
    );
    await prepared;
    if (socket.destroyed) return;
    const caller = callers.read({ headers: {}, socket });
    const rest = source.release();
    // An existing client says its id, and knows no token.
    const claim: ClientClaim = {
      clientId: peer.identity.toString() || undefined,
      token: undefined,
    };
    const refusal = master.refuseConnection(claim, caller);
    if (refusal !== undefined) {
      socket.write(peer.refusal(refusal)); // [AC-27]
      this.#end(socket, true);
      return;
    }
    const connection = new ZeroMqConnection(socket, peer, (isHeld) => this.#end(socket, isHeld));
    const handle = master.openConnection(claim, connection, caller, { addressKind });
    if (handle === undefined) return;
    connection.open();
    connectionGuard?.of(socket)?.handleClient();
    this.#listen(socket, connection, handle, rest);
  }

  #listen(
    socket: Socket,
    connection: ZeroMqConnection,
    handle: ConnectionHandle,
    rest: Buffer,
  ): void {
    const { log, maxMessageBytes } = this.#context;
    const reader = new MessageReader(handle, maxMessageBytes, answersOn(socket));
    const read = (chunk: Buffer): void => {
      handle.handleReadStart();
      try {
        reader.read(chunk);
      } catch (error) {
        if (error instanceof ZmtpError) handle.handleProtocolError(error.message);
        else log.error('a message could not be handled', { reason: String(error) });
        socket.destroy();
      } finally {
        handle.handleReadEnd();
      }
    };
    socket.on('data', read);
    socket.on('drain', () => handle.handleDrain());
    socket.on('close', () => handle.handleClose('lost'));
    if (rest.length > 0) read(rest);
    if (socket.destroyed || this.#ending.has(socket)) return;
    if (connection.isReading) socket.resume();
  }

  /** Reads no more messages, and ends the socket when what was written has left. */
  #end(socket: Socket, isHeld: boolean): void {
    const { clock, holdMs = HOLD_MS } = this.#context;
    this.#ending.add(socket);
    discard(socket);
    const end = (): void => {
      socket.end();
      this.#cutLater(socket, CLOSE_TIMEOUT_MS);
    };
    if (!isHeld || holdMs === 0) {
      end();
      return;
    }
    const cancel = clock.after(holdMs, end);
    socket.once('close', cancel);
  }

  #cutLater(socket: Socket, ms: number): void {
    const cancel = this.#context.clock.after(ms, () => socket.destroy());
    socket.once('close', cancel);
  }
}

/** Reads on, so that the end of the other side is seen, up to a limit. */
function discard(socket: Socket): void {
  let size = 0;
  socket.removeAllListeners('data');
  socket.on('data', (chunk: Buffer) => {
    size += chunk.length;
    if (size > MAX_DISCARDED_BYTES) socket.pause();
  });
  socket.resume();
}
