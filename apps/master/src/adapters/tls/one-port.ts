import type { Server as HttpServer } from 'node:http';
import type { Socket } from 'node:net';
import { createServer } from 'node:tls';
import type { Server as TlsServer } from 'node:tls';

import type { Issued } from './issue-certificates.ts';

/** First byte of a TLS connection: a handshake record (RFC 8446, 5.1). No HTTP request begins so. */
const HANDSHAKE = 22;
/** A connection that has not said what it is by then is cut, milliseconds. */
const SILENT_TIMEOUT_MS = 10_000;
const HANDSHAKE_TIMEOUT_MS = 10_000;

type Serve = (socket: Socket) => void;

/**
 * Adds TLS to HTTP servers on the same port: connections that begin with a handshake use TLS, others are
 * answered as before. One certificate that was accepted covers pages, services and topic data.
 */
export class OnePort {
  #shown: Issued;
  readonly #tlsServers: TlsServer[] = [];
  /** Connections that have sent nothing yet. */
  readonly #silent = new Set<Socket>();

  constructor(shown: Issued) {
    this.#shown = shown;
  }

  /** Shows another certificate from the next connection on. */
  show(shown: Issued): void {
    this.#shown = shown;
    for (const server of this.#tlsServers) server.setSecureContext(secretsOf(shown));
  }

  /** Takes over the connections of a server that does not listen yet. */
  attach(server: HttpServer): void {
    const listeners = server.listeners('connection') as Serve[];
    const serve: Serve = (socket) => {
      for (const listener of listeners) listener.call(server, socket);
    };
    const tlsServer = createServer({
      ...secretsOf(this.#shown),
      minVersion: 'TLSv1.2',
      handshakeTimeout: HANDSHAKE_TIMEOUT_MS,
      ALPNProtocols: ['http/1.1'],
    });
    tlsServer.on('secureConnection', serve);
    // Phones that do not trust the certificate, and scanners, close the connection. Others are not affected.
    tlsServer.on('tlsClientError', (_error, socket) => socket.destroy());
    this.#tlsServers.push(tlsServer);
    server.removeAllListeners('connection');
    server.on('connection', (socket: Socket) => this.#look(socket, tlsServer, serve));
  }

  /** Closes connections that send nothing. */
  cut(): void {
    for (const socket of this.#silent) socket.destroy();
  }

  /** Looks at the first byte and hands the connection on, with all it has sent. */
  #look(socket: Socket, tlsServer: TlsServer, serve: Serve): void {
    const end = (): void => void socket.destroy();
    const leave = (): void => {
      this.#silent.delete(socket);
      socket.off('data', take).off('error', end).off('end', end);
      socket.off('timeout', end).off('close', leave);
      socket.setTimeout(0);
    };
    const take = (first: Buffer): void => {
      leave();
      socket.pause();
      socket.unshift(first);
      if (first[0] === HANDSHAKE) {
        // HTTP may be answered after its sender has ended; TLS is over then.
        socket.allowHalfOpen = false;
        tlsServer.emit('connection', socket);
      } else {
        serve(socket);
        socket.resume();
      }
    };
    this.#silent.add(socket);
    socket.on('data', take).on('error', end).on('end', end);
    socket.on('timeout', end).on('close', leave);
    socket.setTimeout(SILENT_TIMEOUT_MS);
  }
}

function secretsOf({ certificate, key }: Issued): { cert: string; key: string } {
  return { cert: certificate, key };
}
