import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { WebSocket } from 'ws';

import { TRUSTED_CALLER, type ClientClaim, type ConnectionHost } from '../../index.ts';
import {
  Inbox,
  clientConnectionSuite,
  pingText,
  readClose,
  readText,
  readTopicData,
  type ClientEnd,
  type ConnectionBench,
  type Seen,
} from '../../testing/acceptance/index.ts';
import { StreamLog } from '../log/stream-log.ts';
import { OriginPolicy } from '../network/origin-policy.ts';
import { TopicDataSockets } from './topic-data-sockets.ts';

const PROGRAM = 'Suite/1.0';
/** RFC 6455: the connection ended without a close frame. */
const NO_FRAME = 1006;
const LEFT = 4000;

clientConnectionSuite('TopicDataSockets', openBench);

/** Real clients at the other ends of real sockets. */
async function openBench(host: ConnectionHost): Promise<ConnectionBench> {
  const sockets = new TopicDataSockets({
    master: host,
    callers: { prepare: () => undefined, read: () => TRUSTED_CALLER },
    policy: new OriginPolicy({ isOnLan: () => false, host: 'localhost', allowedOrigins: [] }),
    log: new StreamLog({ level: 'error', format: 'json', write: () => {}, nowMs: () => 0 }),
    clock: { after: () => () => undefined },
  });
  const server = createServer().on('upgrade', (request, socket, head) =>
    sockets.handleUpgrade(request, socket, head),
  );
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  return {
    dial: (claim) => new SocketEnd(`ws://127.0.0.1:${port}/?${queryOf(claim)}`),
    caller: TRUSTED_CALLER,
    tells: { program: PROGRAM, token: true, reason: true, leaving: true },
    settle: () => new Promise((resolve) => setImmediate(resolve)),
    async close() {
      sockets.terminate();
      await new Promise((resolve) => server.close(resolve));
    },
  };
}

function queryOf({ clientId, token }: ClientClaim): string {
  return new URLSearchParams({
    ...(token !== undefined && { token }),
    ...(clientId !== undefined && { clientID: clientId }),
  }).toString();
}

class SocketEnd implements ClientEnd {
  readonly #socket: WebSocket;
  readonly #seen = new Inbox<Seen>();
  readonly #opened: Promise<void>;
  readonly #ended: Promise<void>;

  constructor(url: string) {
    const socket = new WebSocket(url, { headers: { 'user-agent': PROGRAM } });
    this.#socket = socket;
    this.#opened = new Promise((resolve) => socket.once('open', resolve));
    this.#ended = new Promise((resolve) => socket.once('close', () => resolve()));
    socket.on('message', (data: Buffer, isBinary) =>
      this.#seen.add(isBinary ? readTopicData(data) : readText(data.toString())),
    );
    // A socket that was refused or cut got no close frame; one that left gets its own back.
    socket.on('close', (code, text) => {
      if (code !== NO_FRAME && code !== LEFT) this.#seen.add(readClose(code, text.toString()));
    });
    socket.on('error', () => {});
  }

  next(): Promise<Seen> {
    return this.#seen.next();
  }

  ended(): Promise<void> {
    return this.#ended;
  }

  sendTopicData(bytes: Uint8Array): void {
    this.#whenOpen(() => this.#socket.send(bytes));
  }

  sendPing(timed?: Parameters<ClientEnd['sendPing']>[0]): void {
    this.#whenOpen(() => this.#socket.send(pingText(timed)));
  }

  sendPong(): void {
    this.#whenOpen(() => this.#socket.send('PONG'));
  }

  sendNonsense(): void {
    this.#whenOpen(() => this.#socket.send('neither PING nor PONG'));
  }

  leave(): void {
    this.#whenOpen(() => this.#socket.close(LEFT, 'left'));
  }

  cut(): void {
    this.#whenOpen(() => this.#socket.terminate());
  }

  pause(): void {
    this.#whenOpen(() => this.#socket.pause());
  }

  resume(): void {
    this.#whenOpen(() => this.#socket.resume());
  }

  #whenOpen(act: () => void): void {
    if (this.#socket.readyState === WebSocket.OPEN) act();
    else if (this.#socket.readyState === WebSocket.CONNECTING) void this.#opened.then(act);
  }
}
