import type { Duplex } from 'node:stream';
import {
  PING_TEXT,
  PONG_TEXT,
  encodeErrorFrame,
  formatPong,
  type TimedPong,
} from '@ubii/proto/wire';
import type { ErrorMessage } from '@ubii/proto';
import type { WebSocket } from 'ws';
import type { FrameParts } from '../output/joined-parts.ts';
import {
  recordListEncoder,
  singleRecordEncoder,
  type MessageHead,
} from '../output/topic-data-encoders.ts';
import type { ClientConnection, CloseReason, RecordBatch } from '../../core/ports/index.ts';
import { closeFrame } from './close-codes.ts';

/*
 * WebSocket frames as a server sends them (RFC 6455, section 5.2): never masked, never fragmented.
 * They are made once and written to the sockets of all who get them.
 */

/** FIN and the opcode. */
const TEXT = 0x81;
const BINARY = 0x82;

export const PING_FRAME = textFrame(PING_TEXT);
export const PONG_FRAME = textFrame(PONG_TEXT);

const HEAD: MessageHead = {
  size: frameHeaderSize,
  write: (target, start, contentBytes) => writeFrameHeader(target, start, BINARY, contentBytes),
};

export const singleFrames = singleRecordEncoder(HEAD);
export const listFrames = recordListEncoder(HEAD);

/** A frame with an error. [TD-17] */
export function errorFrame(error: ErrorMessage): FrameParts {
  return [frame(BINARY, encodeErrorFrame(error))];
}

/** A frame with an encoded `TopicData`. */
function binaryFrame(payload: Uint8Array): FrameParts {
  return [frame(BINARY, payload)];
}

/** A text frame. @param text ASCII */
function textFrame(text: string): FrameParts {
  return [frame(TEXT, Buffer.from(text, 'latin1'))];
}

function frame(firstByte: number, payload: Uint8Array): Buffer {
  const { length } = payload;
  const bytes = Buffer.allocUnsafe(frameHeaderSize(length) + length);
  bytes.set(payload, writeFrameHeader(bytes, 0, firstByte, length));
  return bytes;
}

function frameHeaderSize(payloadLength: number): number {
  if (payloadLength < 126) return 2;
  return payloadLength < 0x1_0000 ? 4 : 10;
}

/** Returns the position after the header, where the payload belongs. */
function writeFrameHeader(
  target: Buffer,
  start: number,
  firstByte: number,
  payloadLength: number,
): number {
  target[start] = firstByte;
  if (payloadLength < 126) {
    target[start + 1] = payloadLength;
    return start + 2;
  }
  if (payloadLength < 0x1_0000) {
    target[start + 1] = 126;
    target[start + 2] = payloadLength >>> 8;
    target[start + 3] = payloadLength & 0xff;
    return start + 4;
  }
  target[start + 1] = 127;
  // The limit on a message is far below 2^32 bytes: the upper half of the length stays 0.
  target.writeUInt32BE(0, start + 2);
  return target.writeUInt32BE(payloadLength, start + 6);
}

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
    // the library noticed that, is lost silently.
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
