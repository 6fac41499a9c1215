import type { IncomingMessage } from 'node:http';
import type { Duplex } from 'node:stream';
import type { Clock } from '@ubii/timing';
import { isBinaryPong } from '@ubii/proto/wire';
import { WebSocketServer } from 'ws';
import type { WebSocket } from 'ws';

import type { CallerFacts, ClientClaim, ConnectionHost, Log } from '../../core/ports/index.ts';
import type { CallerReader } from '../access/caller-reader.ts';
import { kindOfPeer } from '../addresses/address-kinds.ts';
import type { ConnectionGuard } from '../network/connection-guard.ts';
import { handleText } from '../heartbeat/handle-text.ts';
import type { OriginPolicy } from '../network/origin-policy.ts';
import { endingOf } from './close-codes.ts';
import type { PreflightSockets } from './preflight-sockets.ts';
import { refuseUpgrade } from './refuse-upgrade.ts';
import { WebSocketConnection } from './websocket-connection.ts';

/** Time for a client to reply to a close frame, including reading earlier data, milliseconds. */
const CLOSE_TIMEOUT_MS = 5_000;

/** Close code of RFC 6455: the server met something it did not expect. */
const INTERNAL_ERROR = 1011;

export interface TopicDataSocketsContext {
  readonly master: ConnectionHost;
  readonly policy: OriginPolicy;
  readonly callers: Pick<CallerReader, 'prepare' | 'read'>;
  readonly log: Log;
  readonly clock: Pick<Clock, 'after'>;
  /** Knows the connections of sockets. */
  readonly connectionGuard?: Pick<ConnectionGuard, 'of'>;
  readonly preflights?: PreflightSockets;
}

/** An upgrade request whose caller is known. */
interface Upgrade {
  readonly request: IncomingMessage;
  readonly socket: Duplex;
  readonly head: Buffer;
  readonly claim: ClientClaim;
  readonly caller: CallerFacts;
}

/** Turns upgrade requests, on any path of any port, into connections of the master. [TD-1] */
export class TopicDataSockets {
  readonly #context: TopicDataSocketsContext;
  /** By the most bytes of a message: the limit of a connection is that of its server. */
  readonly #servers = new Map<number, WebSocketServer>();

  constructor(context: TopicDataSocketsContext) {
    this.#context = context;
  }

  /** To be called for the `upgrade` event of every HTTP server. */
  handleUpgrade(request: IncomingMessage, socket: Duplex, head: Buffer): void {
    const { callers, master, policy } = this.#context;
    const verdict = policy.judge(request.headers);
    const claim = claimOf(request.url ?? '');
    // A page without a name proves to be a client: browsers let it send no header here. [AC-46]
    const isUnproven = verdict.kind === 'nameless' && !claim.token;
    if (verdict.kind === 'refused' || isUnproven) {
      refuseUpgrade(socket, 403, verdict.reason, this.#context.clock);
      return;
    }
    if (this.#context.preflights?.handleUpgrade(request, socket, head)) return; // [AC-29]
    const { headers, httpVersion } = request;
    const isProven = master.provesLocalClient(claim);
    const asked = { headers, httpVersion, socket: request.socket, isProven };
    const prepared = callers.prepare(asked);
    // Read before anything else: of a connection that is gone nothing is known any more.
    const admit = (): void =>
      this.#admit({ request, socket, head, claim, caller: callers.read(asked) });
    if (prepared === undefined) return admit();
    // The only listener meanwhile: Node.js throws an error without a listener.
    const ignore = (): void => undefined;
    socket.on('error', ignore);
    void prepared.then(() => {
      socket.off('error', ignore);
      if (!socket.destroyed) admit();
    });
  }

  #admit(upgrade: Upgrade): void {
    const { request, socket, head, claim, caller } = upgrade;
    const reason = this.#context.master.refuseConnection(claim, caller);
    if (reason !== undefined) {
      refuseUpgrade(socket, 403, reason, this.#context.clock); // [AC-27]
      return;
    }
    const maxBytes = this.#context.master.maxMessageBytes(claim);
    this.#serverFor(maxBytes).handleUpgrade(request, socket, head, (webSocket) => {
      this.#open(webSocket, upgrade, maxBytes);
    });
  }

  #serverFor(maxBytes: number): WebSocketServer {
    let server = this.#servers.get(maxBytes);
    if (server === undefined) {
      server = new WebSocketServer({
        noServer: true,
        maxPayload: maxBytes,
        perMessageDeflate: false,
        // Several messages of one packet are handled in one turn, so that they leave in one write.
        allowSynchronousEvents: true,
        // Newer than the type declarations of the library.
        ...({ closeTimeout: CLOSE_TIMEOUT_MS } satisfies object),
        // Without it the first protocol a client asks for would be confirmed.
        handleProtocols: () => false,
      });
      this.#servers.set(maxBytes, server);
    }
    return server;
  }

  /** Ends what is still open silently. */
  terminate(): void {
    for (const { clients } of this.#servers.values()) {
      for (const webSocket of clients) webSocket.terminate();
    }
    this.#context.preflights?.terminate();
  }

  #open(webSocket: WebSocket, { request, socket, claim, caller }: Upgrade, maxBytes: number): void {
    const { master, log } = this.#context;
    const opened = master.openConnection(
      claim,
      new WebSocketConnection(webSocket, socket),
      caller,
      {
        program: request.headers['user-agent'],
        addressKind: kindOfPeer(request.socket.remoteAddress),
      }, // [EX-25]
    );
    // A socket that breaks reports an error before it closes; without a listener it would be thrown.
    webSocket.on('error', (error: NodeJS.ErrnoException) => {
      log.debug('a socket failed', { reason: error.message });
      if (error.code === 'WS_ERR_UNSUPPORTED_MESSAGE_LENGTH') {
        opened?.handleProtocolError(`A message may have at most ${maxBytes} bytes.`);
      } else if (error.code?.startsWith('WS_ERR_')) {
        opened?.handleProtocolError(`${error.message}.`);
      }
    });
    if (opened === undefined) return;
    this.#context.connectionGuard?.of(socket)?.handleClient();

    // The library reads the socket between these two.
    socket.prependListener('data', () => opened.handleReadStart());
    socket.on('data', () => opened.handleReadEnd());
    webSocket.on('message', (data: Buffer, isBinary) => {
      try {
        // The library copies messages into new memory and keeps no reference.
        if (!isBinary) handleText(opened, data.toString());
        else if (isBinaryPong(data)) opened.handlePong(); // [TD-2]
        else opened.handleTopicData(data);
      } catch (error) {
        log.error('a message could not be handled', { reason: String(error) });
        webSocket.close(INTERNAL_ERROR, 'internal error');
      }
    });
    webSocket.on('close', (code: number) => opened.handleClose(endingOf(code)));
    socket.on('drain', () => opened.handleDrain());
  }
}

/** Any text may stand where a URL should be: nothing of it may throw. */
function claimOf(url: string): ClientClaim {
  const query = new URLSearchParams(url.slice(url.indexOf('?') + 1 || url.length));
  return {
    clientId: query.get('clientID') || undefined,
    token: query.get('token') || undefined,
    sentMs: Number(query.get('sent')) || undefined,
  };
}
