import { encodeCommand, ZmtpError } from './zmtp-frames.ts';

/*
 * How two ends of ZMTP begin. Each sends a signature and its version; then, up to 2.0, the type of its socket and its
 * identity, and since 3.0 the name of a security mechanism and the command READY with both as properties.
 */

/** Types of sockets by their number in ZMTP 2.0. */
const SOCKET_TYPES = [
  ...['PAIR', 'PUB', 'SUB', 'REQ', 'REP', 'DEALER'],
  ...['ROUTER', 'PULL', 'PUSH', 'XPUB', 'XSUB'],
] as const;
export type SocketType = (typeof SOCKET_TYPES)[number];

/** First and last byte of a signature; between them, 8 that do not matter. */
const SIGNATURE_START = 0xff;
const SIGNATURE_END = 0x7f;
const SIGNATURE_BYTES = 10;
/** Signature and version. */
export const OPENING_BYTES = SIGNATURE_BYTES + 1;
/** What follows the version since 3.0: minor version, mechanism, role, filler. */
export const REST_OF_GREETING_BYTES = 53;
const MECHANISM_BYTES = 20;
/** Number for version 2.0 in the greeting: revision 1 of the protocol of frames. */
const REVISION_OF_V2 = 1;
const MAJOR_OF_V3 = 3;

/** Version of the protocol that both ends speak. */
export type ZmtpVersion = 2 | 3;

/** Signature and version of the master: what it sends first, whatever comes. */
export const OPENING: Buffer = Buffer.from([
  SIGNATURE_START,
  ...Array<number>(SIGNATURE_BYTES - 2).fill(0),
  SIGNATURE_END,
  MAJOR_OF_V3,
]);

/** The rest of the greeting of 3.1: without a security mechanism, as the original master. */
export const REST_OF_GREETING: Buffer = Buffer.alloc(REST_OF_GREETING_BYTES).fill(
  Buffer.from('\x01NULL', 'latin1'),
  0,
  5,
);

/** @throws ZmtpError when these bytes are not the beginning of ZMTP 2.0 or later */
export function readOpening(opening: Buffer): ZmtpVersion {
  if (opening[0] !== SIGNATURE_START || opening[SIGNATURE_BYTES - 1] !== SIGNATURE_END) {
    throw new ZmtpError('The connection is not of ZeroMQ.');
  }
  const version = opening[SIGNATURE_BYTES]!;
  if (version >= MAJOR_OF_V3) return 3;
  if (version === REVISION_OF_V2) return 2;
  throw new ZmtpError('The peer speaks a version of ZMTP before 2.0.');
}

/** @throws ZmtpError when the other end wants a security mechanism */
export function checkRestOfGreeting(rest: Buffer): void {
  const mechanism = rest.toString('latin1', 1, 1 + MECHANISM_BYTES).replace(/\0+$/, '');
  if (mechanism !== 'NULL') {
    throw new ZmtpError(`The peer wants a security mechanism other than NULL.`);
  }
}

/** Type of a socket by its number in 2.0; undefined when there is none. */
export function socketTypeOf(number: number): SocketType | undefined {
  return SOCKET_TYPES[number];
}

/** The byte for a type in 2.0. */
export function socketTypeByte(type: SocketType): Buffer {
  return Buffer.from([SOCKET_TYPES.indexOf(type)]);
}

/** The command READY of a socket without an identity. */
export function encodeReady(type: SocketType): Buffer {
  return encodeCommand('READY', encodeProperty('Socket-Type', type));
}

/** What a peer says of itself in READY. */
export interface PeerProperties {
  readonly socketType: string;
  readonly identity: Buffer;
}

/** @throws ZmtpError when the properties are not complete */
export function readReady(data: Buffer): PeerProperties {
  let socketType = '';
  let identity: Buffer = Buffer.alloc(0);
  for (let pos = 0; pos < data.length;) {
    const nameEnd = pos + 1 + data[pos]!;
    if (nameEnd + 4 > data.length) throw new ZmtpError('A property of READY is cut off.');
    const valueEnd = nameEnd + 4 + data.readUInt32BE(nameEnd);
    if (valueEnd > data.length) throw new ZmtpError('A property of READY is cut off.');
    const name = data.toString('latin1', pos + 1, nameEnd).toLowerCase();
    const value = data.subarray(nameEnd + 4, valueEnd);
    if (name === 'socket-type') socketType = value.toString('latin1');
    else if (name === 'identity') identity = value;
    pos = valueEnd;
  }
  return { socketType, identity };
}

/** Most bytes of the reason in ERROR. */
const MAX_REASON_BYTES = 180;

/** The command ERROR, which takes the place of READY: the peer is not wanted. */
export function encodeError(reason: string): Buffer {
  const text = Buffer.from(reason.replace(/[^\x20-\x7e]/g, '?'), 'latin1').subarray(
    0,
    MAX_REASON_BYTES,
  );
  return encodeCommand('ERROR', Buffer.concat([Buffer.from([text.length]), text]));
}

function encodeProperty(name: string, value: string): Buffer {
  const size = Buffer.alloc(4);
  size.writeUInt32BE(value.length);
  return Buffer.concat([
    Buffer.from([name.length]),
    Buffer.from(name, 'latin1'),
    size,
    Buffer.from(value, 'latin1'),
  ]);
}
