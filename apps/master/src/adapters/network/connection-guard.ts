import type { Server, Socket } from 'node:net';
import type { Duplex } from 'node:stream';

import type { OpenConnection } from '../../core/connections/open-connection.ts';
import type { Master } from '../../core/master/master.ts';
import { isLoopbackHost, placeOf, plainAddress } from '../addresses/address-kinds.ts';

export interface ConnectionGuardContext {
  readonly master: Pick<Master, 'admitConnection'>;
  /** Whether an address is one of this machine. */
  readonly isOwnAddress: (address: string) => boolean;
}

/** Asks the master about every connection before a byte of it is read, on every port. [AC-60] */
export class ConnectionGuard {
  readonly #context: ConnectionGuardContext;
  /** By both ends: TLS puts a socket of its own around that which was accepted. */
  readonly #byEnds = new Map<string, OpenConnection>();

  constructor(context: ConnectionGuardContext) {
    this.#context = context;
  }

  /** To be called when all listeners for connections of this server are there: it stands before them. */
  guard(server: Server): void {
    const listeners = server.listeners('connection') as ((socket: Socket) => void)[];
    server.removeAllListeners('connection');
    server.on('connection', (socket: Socket) => {
      if (!this.#admit(socket)) return;
      for (const listener of listeners) listener.call(server, socket);
    });
  }

  /** The connection of a socket; undefined when it is closed. */
  of(socket: Duplex): OpenConnection | undefined {
    const ends = endsOf(socket as Socket);
    return ends === undefined ? undefined : this.#byEnds.get(ends);
  }

  #admit(socket: Socket): boolean {
    const address = plainAddress(socket.remoteAddress);
    const ends = endsOf(socket);
    if (address === undefined || ends === undefined) {
      // It is gone already.
      socket.destroy();
      return false;
    }
    const isLocal = isLoopbackHost(address) || this.#context.isOwnAddress(address);
    const peer = { address, network: placeOf(address), isLocal };
    const connection = this.#context.master.admitConnection(peer, () => socket.resetAndDestroy());
    if (connection === undefined) {
      // A reset leaves nothing behind; a close would keep its port for a minute.
      socket.on('error', () => undefined).resetAndDestroy();
      return false;
    }
    this.#byEnds.set(ends, connection);
    socket.once('close', () => {
      this.#byEnds.delete(ends);
      connection.handleClose();
    });
    return true;
  }
}

function endsOf({
  remoteAddress,
  remotePort,
  localAddress,
  localPort,
}: Socket): string | undefined {
  if (remoteAddress === undefined || localAddress === undefined) return undefined;
  return `${remoteAddress} ${remotePort} ${localAddress} ${localPort}`;
}
