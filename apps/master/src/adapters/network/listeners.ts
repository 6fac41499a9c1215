import { createServer, Server as HttpServer } from 'node:http';
import type { IncomingMessage, RequestListener } from 'node:http';
import { createServer as createPlainServer } from 'node:net';
import type { Server, Socket } from 'node:net';
import type { Duplex } from 'node:stream';

import type { OnePort } from '../tls/one-port.ts';
import type { LegacyPorts } from '../config/legacy-ports.ts';
import type { Log } from '../../core/ports/index.ts';
import { oneAtATime } from './one-at-a-time.ts';
import type { ConnectionGuard } from './connection-guard.ts';
import { explainListenError } from './explain-listen-error.ts';
import { openPort } from './open-port.ts';

export interface ListenersContext {
  /** Initial host to listen on, see `openPort`. */
  readonly host: string;
  readonly handleRequest: RequestListener;
  readonly handleUpgrade: (request: IncomingMessage, socket: Duplex, head: Buffer) => void;
  /** Take the connections of the ports of ZeroMQ. */
  readonly zeromq?: PlainEnds;
  /** Answers HTTPS on the same ports at first; undefined: they are for HTTP only. */
  readonly onePort: OnePort | undefined;
  /** Says who may connect; undefined: everybody. */
  readonly connectionGuard?: ConnectionGuard;
  /** Milliseconds. @default Node's own limits */
  readonly timeouts?: ConnectionTimeouts;
  readonly log: Log;
}

/** What takes connections that are not of HTTP. */
export interface PlainEnds {
  readonly services: (socket: Socket) => void;
  readonly topicData: (socket: Socket) => void;
}

/** Timeouts of connections, milliseconds. [AC-63] */
export interface ConnectionTimeouts {
  /** The headers of a request, from its first byte or the end of a TLS handshake. */
  readonly headersMs: number;
  /** During which nothing comes and nothing is taken, while a request is answered. */
  readonly stillMs: number;
  /** With nothing to do, after an answer. Default: 5000. */
  readonly keepAliveMs?: number | undefined;
}

/** Interval at which Node.js checks for late headers, milliseconds. */
const CHECK_INTERVAL_MS = 1_000;
/** A connection that has nothing to do is closed after this time, milliseconds. */
const KEEP_ALIVE_MS = 5_000;
/** A request with its body has come by then, milliseconds. Bodies have a pace to keep besides. [SV-47] */
const REQUEST_TIMEOUT_MS = 600_000;

/** The ports to open. */
export interface WantedPorts {
  readonly main: number;
  readonly legacy: LegacyPorts | undefined;
  /** The legacy ports were requested: an unavailable port is an error, not a warning. */
  readonly legacyWished: boolean;
  /** Ports of ZeroMQ, apart from all others; they are open only when requested. */
  readonly zeromq?: LegacyPorts | undefined;
}

/** The open ports, and whether they use HTTPS. */
export interface Reach {
  /** See `openPort`. */
  readonly host: string;
  readonly onePort: OnePort | undefined;
}

/** The ports clients are told. */
export interface ListeningPorts {
  readonly main: number;
  /** Port of services for existing clients; the main port when the legacy port is not open. */
  readonly services: number;
  /** Port of topic data for existing clients; the main port when the legacy port is not open. */
  readonly topicData: number;
  /** Undefined when they are not open. */
  readonly zeromq?: LegacyPorts;
}

/** A port that is open, and what makes it so again. */
interface OpenedPort {
  readonly servers: readonly Server[];
  readonly option: string;
  readonly createServer: () => Server;
}

/** The servers of the master: whatever port a request over HTTP comes to, it is handled the same. */
export class Listeners {
  readonly #context: ListenersContext;
  readonly #opened = new Map<number, OpenedPort>();
  /** Servers that listen no more, and answer the connections that they have. */
  readonly #retired: Server[] = [];
  /** Settle when the last connection of a server that was closed ended. */
  readonly #ends: Promise<unknown>[] = [];
  #reach: Reach;
  #ports: ListeningPorts = { main: 0, services: 0, topicData: 0 };

  constructor(context: ListenersContext) {
    this.#context = context;
    this.#reach = { host: context.host, onePort: context.onePort };
  }

  /** All zero before `open` is done. */
  get ports(): ListeningPorts {
    return this.#ports;
  }

  /** @throws ConfigError for a port that cannot be had; those opened before stay open until `close` */
  async open({ main, legacy, legacyWished, zeromq }: WantedPorts): Promise<void> {
    const mainPort = await this.#open(main, '--port');
    const openLegacy = async (port: number): Promise<number> => {
      try {
        return await this.#open(port, '--legacy-ports');
      } catch (error) {
        if (legacyWished || !(error instanceof Error)) throw error;
        this.#context.log.warn(
          `${error.message} Configure existing clients to use port ${mainPort}.`,
        );
        return mainPort;
      }
    };
    this.#ports = {
      main: mainPort,
      services: legacy ? await openLegacy(legacy.services) : mainPort,
      topicData: legacy ? await openLegacy(legacy.topicData) : mainPort,
    };
    if (zeromq !== undefined)
      this.#ports = { ...this.#ports, zeromq: await this.#openZeroMq(zeromq) };
  }

  /**
   * Listens on the same ports of another host. Open connections stay; for the moment in which a port changes hands,
   * new ones are refused. A legacy port that cannot be had there stays where it is, with a warning.
   *
   * @throws ConfigError when the main port cannot be had there; everything is as before then
   */
  async move(reach: Reach): Promise<void> {
    const before = this.#reach;
    const opened = [...this.#opened];
    const main = opened.find(([port]) => port === this.#ports.main);
    if (main === undefined) return;
    this.#reach = reach;
    try {
      await this.#reopen(...main);
    } catch (error) {
      this.#reach = before;
      await this.#reopen(...main);
      throw error;
    }
    for (const other of opened.filter((each) => each !== main)) {
      try {
        await this.#reopen(...other);
      } catch (error) {
        this.#context.log.warn(`${String((error as Error).message)} It stays as it was.`);
        this.#reach = before;
        await this.#reopen(...other);
        this.#reach = reach;
      }
    }
  }

  /** Takes no more connections and ends the idle ones; settles when the last one ended. */
  async close(): Promise<void> {
    for (const port of [...this.#opened.keys()]) this.#retire(port);
    await Promise.all(this.#ends);
  }

  /** Cuts what is still being answered. Upgraded connections are not ours any more. */
  cut(): void {
    this.#reach.onePort?.cut();
    const open = [...this.#opened.values()].flatMap(({ servers }) => servers);
    for (const server of [...open, ...this.#retired]) {
      if (server instanceof HttpServer) server.closeAllConnections();
    }
  }

  async #reopen(port: number, { option, createServer }: OpenedPort): Promise<void> {
    this.#retire(port);
    await this.#open(port, option, createServer);
  }

  async #openZeroMq({ services, topicData }: LegacyPorts): Promise<LegacyPorts> {
    const { zeromq } = this.#context;
    if (zeromq === undefined) throw new Error('nothing takes connections of ZeroMQ');
    const open = (port: number, take: (socket: Socket) => void): Promise<number> =>
      this.#open(port, '--zeromq-ports', () => this.#createPlainServer(take));
    return {
      services: await open(services, zeromq.services),
      topicData: await open(topicData, zeromq.topicData),
    };
  }

  /** Stops listening on a port, at once. */
  #retire(port: number): void {
    const servers = this.#opened.get(port)?.servers ?? [];
    this.#opened.delete(port);
    for (const server of servers) {
      this.#retired.push(server);
      this.#ends.push(new Promise((resolve) => server.close(resolve)));
    }
  }

  async #open(
    port: number,
    option: string,
    createServer = (): Server => this.#createServer(),
  ): Promise<number> {
    if (this.#opened.has(port)) return port;
    const { host } = this.#reach;
    try {
      const opened = await openPort(port, host, createServer);
      this.#opened.set(opened.port, { servers: opened.servers, option, createServer });
      return opened.port;
    } catch (error) {
      throw explainListenError(error, { port, host, option });
    }
  }

  #createPlainServer(take: (socket: Socket) => void): Server {
    const server = createPlainServer(take);
    this.#context.connectionGuard?.guard(server);
    return server;
  }

  #createServer(): Server {
    const { handleRequest, handleUpgrade, connectionGuard, timeouts } = this.#context;
    const { onePort } = this.#reach;
    const context = {
      requestTimeout: REQUEST_TIMEOUT_MS,
      connectionsCheckingInterval: CHECK_INTERVAL_MS,
      keepAliveTimeout: timeouts?.keepAliveMs ?? KEEP_ALIVE_MS,
      ...(timeouts && { headersTimeout: timeouts.headersMs }),
    };
    const server = createServer(
      context,
      oneAtATime((request, response) => {
        connectionGuard?.of(request.socket)?.handleRequest();
        handleRequest(request, response);
      }),
    );
    if (timeouts) server.timeout = timeouts.stillMs;
    server.on('upgrade', (request, socket, head) => {
      connectionGuard?.of(socket)?.handleRequest();
      handleUpgrade(request, socket, head);
    });
    onePort?.attach(server);
    connectionGuard?.guard(server);
    return server;
  }
}
