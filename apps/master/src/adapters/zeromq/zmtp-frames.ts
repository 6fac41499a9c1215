/*
 * Frames of ZMTP, the protocol that ZeroMQ speaks over TCP: https://rfc.zeromq.org/spec/23 (3.0), /37 (3.1) and
 * /15 (2.0). A frame is a byte of flags, its size in 1 or 8 bytes, and its body.
 */

/** More frames of the same message follow. */
export const MORE = 0x01;
/** The size has 8 bytes. */
const LONG = 0x02;
/** The frame is a command of the protocol, not a part of a message. */
const COMMAND = 0x04;

const SHORT_HEADER_BYTES = 2;
const LONG_HEADER_BYTES = 9;
/** Largest body with a size of 1 byte. */
const MAX_SHORT_BYTES = 255;
/** Largest body of a command after the greeting: PING and PONG have less. */
export const MAX_COMMAND_BYTES: number = MAX_SHORT_BYTES;
const TWO_TO_32 = 0x1_0000_0000;

/** The frame that ends the envelope of a message: empty, with a message behind it. */
export const DELIMITER: Buffer = Buffer.from([MORE, 0]);

/** What stands in front of a body. */
export interface FrameHeader {
  readonly isCommand: boolean;
  readonly hasMore: boolean;
  /** Size of the header itself. */
  readonly headerBytes: number;
  /** Size of the body. */
  readonly bodyBytes: number;
}

/** Input that is not ZMTP, or more than is taken: the connection is of no more use. */
export class ZmtpError extends Error {
  override readonly name = 'ZmtpError';
}

/** Number of bytes of a header that begins with these flags. @throws ZmtpError for flags that do not exist */
export function headerBytesOf(flags: number): number {
  if (flags > (MORE | LONG | COMMAND) || (flags & (COMMAND | MORE)) === (COMMAND | MORE)) {
    throw new ZmtpError(`A frame begins with the unknown flags ${flags}.`);
  }
  return (flags & LONG) === 0 ? SHORT_HEADER_BYTES : LONG_HEADER_BYTES;
}

/**
 * Reads the header at `start`, all of whose bytes must be there.
 *
 * @throws ZmtpError for flags that do not exist, and for a body of more than `maxBytes`
 */
export function readFrameHeader(bytes: Buffer, start: number, maxBytes: number): FrameHeader {
  const flags = bytes[start]!;
  const headerBytes = headerBytesOf(flags);
  const bodyBytes =
    headerBytes === SHORT_HEADER_BYTES
      ? bytes[start + 1]!
      : bytes.readUInt32BE(start + 1) * TWO_TO_32 + bytes.readUInt32BE(start + 5);
  if (bodyBytes > maxBytes) throw new ZmtpError(`A message may have at most ${maxBytes} bytes.`);
  return {
    isCommand: (flags & COMMAND) !== 0,
    hasMore: (flags & MORE) !== 0,
    headerBytes,
    bodyBytes,
  };
}

/** Bytes that `writeFrameHeader` writes for a body of this size. */
export function frameHeaderSize(bodyBytes: number): number {
  return bodyBytes > MAX_SHORT_BYTES ? LONG_HEADER_BYTES : SHORT_HEADER_BYTES;
}

/**
 * Writes the header of the last frame of a message.
 *
 * @param bodyBytes below 2^32
 * @returns the position after it, where the body belongs
 */
export function writeFrameHeader(target: Buffer, start: number, bodyBytes: number): number {
  if (bodyBytes <= MAX_SHORT_BYTES) {
    target[start] = 0;
    target[start + 1] = bodyBytes;
    return start + SHORT_HEADER_BYTES;
  }
  target[start] = LONG;
  target.writeUInt32BE(0, start + 1);
  return target.writeUInt32BE(bodyBytes, start + 5);
}

/** A whole frame with a body that is copied. */
export function encodeFrame(body: Uint8Array, flags: 0 | typeof MORE = 0): Buffer {
  const size = frameHeaderSize(body.length);
  const frame = Buffer.allocUnsafe(size + body.length);
  frame.set(body, writeFrameHeader(frame, 0, body.length));
  frame[0]! |= flags;
  return frame;
}

/** A command: its name, and data of at most 200 bytes. */
export function encodeCommand(name: string, data: Uint8Array): Buffer {
  const body = Buffer.concat([Buffer.from([name.length]), Buffer.from(name, 'latin1'), data]);
  const frame = encodeFrame(body);
  frame[0]! |= COMMAND;
  return frame;
}

/** Name and data of a command. @throws ZmtpError when it has no name */
export function readCommand(body: Buffer): { readonly name: string; readonly data: Buffer } {
  const nameBytes = body[0] ?? 0;
  if (nameBytes === 0 || body.length < 1 + nameBytes) {
    throw new ZmtpError('A command has no name.');
  }
  return {
    name: body.toString('latin1', 1, 1 + nameBytes),
    data: body.subarray(1 + nameBytes),
  };
}
