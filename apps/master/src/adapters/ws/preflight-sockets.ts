import type { IncomingMessage } from 'node:http';
import type { Duplex } from 'node:stream';
import type { PreciseClock } from '@ubii/timing';
import { WebSocketServer } from 'ws';
import type { WebSocket } from 'ws';

import { SOCKET_RIGHTS } from '../../core/access/rights-table.ts';
import { refuseUpgrade } from './refuse-upgrade.ts';

/** Path at which pages test WebSockets before joining. [AC-29] */
const PATH = SOCKET_RIGHTS.preflight.path;

/** A question is a counter; nothing longer is answered. */
const MAX_MESSAGE_BYTES = 32;
/** A preflight asks five times. */
const MAX_QUESTIONS = 16;
const LIFETIME_MS = 10_000;
/** Strangers may open these: all phones of a class at once, and no more. */
const MAX_OPEN = 64;
const MAX_OPEN_OF_ONE_ADDRESS = 8;

/** Close code of RFC 6455: the other side does what it may not. */
const POLICY_VIOLATION = 1008;

/**
 * Sockets that carry nothing: each question comes back with the master's time behind it. They tell a page
 * that is not admitted yet whether the live channel will work, how fast it is and what the time is.
 */
export class PreflightSockets {
  readonly #clock: Pick<PreciseClock, 'preciseMs' | 'after'>;
  readonly #server = new WebSocketServer({
    noServer: true,
    maxPayload: MAX_MESSAGE_BYTES,
    perMessageDeflate: false,
    handleProtocols: () => false,
  });
  readonly #openByAddress = new Map<string, number>();

  constructor(clock: Pick<PreciseClock, 'preciseMs' | 'after'>) {
    this.#clock = clock;
  }

  /** @returns false when the request is for something else */
  handleUpgrade(request: IncomingMessage, socket: Duplex, head: Buffer): boolean {
    if (request.url !== PATH) return false;
    const address = request.socket.remoteAddress ?? '';
    const open = this.#openByAddress.get(address) ?? 0;
    if (this.#server.clients.size >= MAX_OPEN || open >= MAX_OPEN_OF_ONE_ADDRESS) {
      const reason = 'Too many pages are testing their connection. Try again in a moment.';
      refuseUpgrade(socket, 503, reason, this.#clock);
      return true;
    }
    this.#server.handleUpgrade(request, socket, head, (webSocket) => {
      this.#openByAddress.set(address, open + 1);
      webSocket.once('close', () => this.#forget(address));
      this.#answer(webSocket);
    });
    return true;
  }

  /** Ends what is still open silently. */
  terminate(): void {
    for (const webSocket of this.#server.clients) webSocket.terminate();
  }

  #answer(webSocket: WebSocket): void {
    const cancel = this.#clock.after(LIFETIME_MS, () => webSocket.terminate());
    let questions = 0;
    webSocket.on('close', cancel);
    // A socket that breaks reports an error before it closes; without a listener it would be thrown.
    webSocket.on('error', () => webSocket.terminate());
    webSocket.on('message', (data: Buffer, isBinary) => {
      questions += 1;
      if (isBinary || questions > MAX_QUESTIONS) {
        webSocket.close(POLICY_VIOLATION, 'a preflight sends only a few short messages');
        return;
      }
      webSocket.send(`${data.toString()} ${this.#clock.preciseMs()}`);
    });
  }

  #forget(address: string): void {
    const open = (this.#openByAddress.get(address) ?? 1) - 1;
    if (open > 0) this.#openByAddress.set(address, open);
    else this.#openByAddress.delete(address);
  }
}
