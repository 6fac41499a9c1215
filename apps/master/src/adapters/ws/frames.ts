import {
  PING_TEXT,
  PONG_TEXT,
  encodeErrorFrame,
  listHeaderSize,
  recordHeaderSize,
  recordListSize,
  writeElementHeader,
  writeListHeader,
  writeRecordHeader,
} from '@ubii/proto/wire';
import type { ErrorMessage } from '@ubii/proto';

import type { BatchEncoder } from '../../core/ports/index.ts';
import { JoinedParts, joinedSize, type FrameParts } from '../output/joined-parts.ts';

/*
 * WebSocket frames as a server sends them (RFC 6455, section 5.2): never masked, never fragmented.
 * They are made once and written to the sockets of all who get them.
 */

/** FIN and the opcode. */
const TEXT = 0x81;
const BINARY = 0x82;

export const PING_FRAME = textFrame(PING_TEXT);
export const PONG_FRAME = textFrame(PONG_TEXT);

/** Makes the frames of a batch. */
export type FrameEncoder = BatchEncoder<FrameParts>;

/** One frame for each record. [TD-3] */
export const singleFrames: FrameEncoder = {
  encode({ records }) {
    let size = 0;
    for (let i = 0; i < records.length; i++) {
      const { length } = records[i]!;
      const payloadLength = recordHeaderSize(length) + length;
      size += frameHeaderSize(payloadLength) + recordHeaderSize(length) + joinedSize(length);
    }
    const parts = new JoinedParts(size);
    for (let i = 0; i < records.length; i++) {
      const record = records[i]!;
      const { length } = record;
      const payloadLength = recordHeaderSize(length) + length;
      parts.pos = writeFrameHeader(parts.bytes, parts.pos, BINARY, payloadLength);
      parts.pos = writeRecordHeader(parts.bytes, parts.pos, length);
      parts.add(record);
    }
    return parts.finish();
  },
};

/** One frame for all records. [TD-4] */
export const listFrames: FrameEncoder = {
  encode({ records }) {
    const listSize = recordListSize(records);
    const payloadLength = listHeaderSize(listSize) + listSize;
    let size = frameHeaderSize(payloadLength) + payloadLength;
    for (let i = 0; i < records.length; i++) {
      const { length } = records[i]!;
      size -= length - joinedSize(length);
    }
    const parts = new JoinedParts(size);
    parts.pos = writeFrameHeader(parts.bytes, parts.pos, BINARY, payloadLength);
    parts.pos = writeListHeader(parts.bytes, parts.pos, listSize);
    for (let i = 0; i < records.length; i++) {
      const record = records[i]!;
      parts.pos = writeElementHeader(parts.bytes, parts.pos, record.length);
      parts.add(record);
    }
    return parts.finish();
  },
};

/** A frame with an error. [TD-17] */
export function errorFrame(error: ErrorMessage): FrameParts {
  return [frame(BINARY, encodeErrorFrame(error))];
}

/** A frame with an encoded `TopicData`. */
export function binaryFrame(payload: Uint8Array): FrameParts {
  return [frame(BINARY, payload)];
}

/** A text frame. @param text ASCII */
export function textFrame(text: string): FrameParts {
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
