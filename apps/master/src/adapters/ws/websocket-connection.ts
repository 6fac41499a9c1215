import type { ErrorMessage } from '@ubii/proto';
import type { Duplex } from 'node:stream';
import type { WebSocket } from 'ws';

import type { ClientConnection, RecordBatch } from '../../core/ports/index.ts';
import {
  PING_FRAME,
  PONG_FRAME,
  binaryFrame,
  errorFrame,
  listFrames,
  singleFrames,
  textFrame,
} from './frames.ts';
import type { FrameParts } from './joined-parts.ts';

/** Longest reason of a close frame besides its code, bytes (RFC 6455, section 5.5.1). */
const MAX_REASON_BYTES = 123;

/** WebSocket.OPEN */
const OPEN = 1;

/**
 * One client's WebSocket. Frames are made here and written straight to the socket of the upgrade:
 * the library would make each of them again for each client. It still reads the frames that come,
 * and speaks for itself in control frames; without compression it never holds a frame back, so the
 * two never mix.
 */
export class WebSocketConnection implements ClientConnection {
  readonly #webSocket: WebSocket;
  readonly #socket: Duplex;
  #recordLists = false;

  /**
   * @param webSocket without compression
   * @param socket the one `webSocket` was made of
   */
  constructor(webSocket: WebSocket, socket: Duplex) {
    this.#webSocket = webSocket;
    this.#socket = socket;
  }

  send(batch: RecordBatch): void {
    const encoder = this.#recordLists && batch.count > 1 ? listFrames : singleFrames;
    this.#write(batch.memo(encoder));
  }

  sendError(error: ErrorMessage): void {
    this.#write(errorFrame(error));
  }

  sendFrame(frame: Uint8Array): void {
    this.#write(binaryFrame(frame));
  }

  // [TD-5]
  sendPing(): void {
    this.#write(PING_FRAME);
  }

  // [TD-2]
  sendPong(text?: string): void {
    this.#write(text === undefined ? PONG_FRAME : textFrame(text));
  }

  get queuedBytes(): number {
    return this.#socket.writableLength;
  }

  close(code: number, reason: string): void {
    this.#webSocket.close(code, Buffer.from(reason).subarray(0, MAX_REASON_BYTES));
  }

  setRecordLists(on: boolean): void {
    this.#recordLists = on;
  }

  #write(parts: FrameParts): void {
    // Nothing may follow the close frame. What is written to a socket that broke a moment ago, before
    // the library heard of it, is lost silently.
    if (this.#webSocket.readyState !== OPEN) return;
    if (parts.length === 1) {
      this.#socket.write(parts[0]);
      return;
    }
    this.#socket.cork();
    for (const part of parts) this.#socket.write(part);
    this.#socket.uncork();
  }
}
