import type { ErrorMessage } from '@ubii/proto';
import { formatPong, type TimedPong } from '@ubii/proto/wire';
import type { Duplex } from 'node:stream';
import type { WebSocket } from 'ws';

import type { ClientConnection, CloseReason, RecordBatch } from '../../core/ports/index.ts';
import { closeFrame } from './close-codes.ts';
import {
  PING_FRAME,
  PONG_FRAME,
  binaryFrame,
  errorFrame,
  listFrames,
  singleFrames,
  textFrame,
} from './frames.ts';
import type { FrameParts } from '../output/joined-parts.ts';

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
  sendPong(timed?: TimedPong): void {
    this.#write(timed === undefined ? PONG_FRAME : textFrame(formatPong(timed)));
  }

  get queuedBytes(): number {
    return this.#socket.writableLength;
  }

  close(reason: CloseReason, explanation?: string): void {
    const { code, text } = closeFrame(reason, explanation);
    this.#webSocket.close(code, text);
  }

  setRecordLists(on: boolean): void {
    this.#recordLists = on;
  }

  setReading(on: boolean): void {
    if (on) this.#webSocket.resume();
    else this.#webSocket.pause();
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
