import { encodeErrorFrame, encodeRecordListFrame, recordFrameHeader } from '@ubii/proto/wire';
import type { ErrorMessage } from '@ubii/proto';

import type { RecordBatch } from '../../core/ports/index.ts';

/*
 * WebSocket frames as a server sends them (RFC 6455, section 5.2): never masked, never fragmented.
 * They are made once and written to the sockets of all who get them.
 */

/** The pieces of one write. */
export type FrameParts = readonly Buffer[];

/** FIN and the opcode. */
const TEXT = 0x81;
const BINARY = 0x82;

/** From this size on a record is handed to the system where it lies instead of being copied. */
const LARGE_BYTES = 16 * 1024;

export const PING_FRAME = textFrame('PING');
export const PONG_FRAME = textFrame('PONG');

/** Makes the frames of a batch. It is its own key in the batch's memo. */
export interface FrameEncoder {
  encode(batch: RecordBatch): FrameParts;
}

/** One frame for each record. [TD-3] */
export const singleFrames: FrameEncoder = {
  encode({ records }) {
    const joined = new JoinedParts();
    for (const record of records) {
      const header = recordFrameHeader(record.length);
      joined.add(frameHeader(BINARY, header.length + record.length));
      joined.add(header);
      joined.add(record);
    }
    return joined.finish();
  },
};

/** One frame for all records. [TD-4] */
export const listFrames: FrameEncoder = {
  encode({ records }) {
    return binaryFrame(encodeRecordListFrame(records));
  },
};

/** A frame with an error. [TD-17] */
export function errorFrame(error: ErrorMessage): FrameParts {
  return binaryFrame(encodeErrorFrame(error));
}

function binaryFrame(payload: Uint8Array): FrameParts {
  const joined = new JoinedParts();
  joined.add(frameHeader(BINARY, payload.length));
  joined.add(payload);
  return joined.finish();
}

function textFrame(text: string): FrameParts {
  return [Buffer.concat([frameHeader(TEXT, text.length), Buffer.from(text, 'latin1')])];
}

function frameHeader(firstByte: number, payloadLength: number): Uint8Array {
  if (payloadLength < 126) return Uint8Array.of(firstByte, payloadLength);
  if (payloadLength < 0x1_0000) {
    return Uint8Array.of(firstByte, 126, payloadLength >>> 8, payloadLength & 0xff);
  }
  const header = Buffer.alloc(10);
  header[0] = firstByte;
  header[1] = 127;
  // The limit on a message is far below 2^32 bytes: the upper half of the length stays 0.
  header.writeUInt32BE(payloadLength, 6);
  return header;
}

/** Joins what is small and keeps what is large as it is, in order. */
class JoinedParts {
  readonly #parts: Buffer[] = [];
  #small: Uint8Array[] = [];
  #smallBytes = 0;

  add(bytes: Uint8Array): void {
    if (bytes.length > LARGE_BYTES) {
      this.#flush();
      this.#parts.push(Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength));
    } else {
      this.#small.push(bytes);
      this.#smallBytes += bytes.length;
    }
  }

  finish(): FrameParts {
    this.#flush();
    return this.#parts;
  }

  #flush(): void {
    if (this.#smallBytes === 0) return;
    const joined = Buffer.allocUnsafe(this.#smallBytes);
    let offset = 0;
    for (const bytes of this.#small) {
      joined.set(bytes, offset);
      offset += bytes.length;
    }
    this.#parts.push(joined);
    this.#small = [];
    this.#smallBytes = 0;
  }
}
