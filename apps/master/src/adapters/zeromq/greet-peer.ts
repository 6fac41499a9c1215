import type { Socket } from 'node:net';

import type { ByteSource } from './byte-source.ts';
import {
  OPENING,
  OPENING_BYTES,
  REST_OF_GREETING,
  REST_OF_GREETING_BYTES,
  checkRestOfGreeting,
  encodeError,
  encodeReady,
  readOpening,
  readReady,
  socketTypeByte,
  socketTypeOf,
  type PeerProperties,
  type SocketType,
  type ZmtpVersion,
} from './greeting.ts';
import { readFrame } from './read-frame.ts';
import { ZmtpError, encodeFrame, readCommand } from './zmtp-frames.ts';

/** Most that a peer may say of itself, bytes. Libraries say its type and identity. */
const MAX_PROPERTIES_BYTES = 1_024;
/** Most bytes of an identity. */
const MAX_IDENTITY_BYTES = 255;

/** A peer that has sent its greeting, and waits to be accepted or refused. */
export class ZmtpPeer {
  /** Identity that the peer asks for; empty for any. */
  readonly identity: Buffer;
  readonly #version: ZmtpVersion;
  readonly #own: SocketType;

  constructor(version: ZmtpVersion, own: SocketType, identity: Buffer) {
    this.#version = version;
    this.#own = own;
    this.identity = identity;
  }

  /** What takes the peer: messages follow. */
  get acceptance(): Buffer {
    if (this.#version === 3) return encodeReady(this.#own);
    return Buffer.concat([socketTypeByte(this.#own), encodeFrame(Buffer.alloc(0))]);
  }

  /** What refuses it, in place of the acceptance; empty where the version has no words for it. */
  refusal(reason: string): Buffer {
    return this.#version === 3 ? encodeError(reason) : Buffer.alloc(0);
  }
}

/** What stands at this end of a connection. */
export interface OwnEnd {
  readonly own: SocketType;
  /** The types of sockets that it talks with. */
  readonly accepted: readonly SocketType[];
}

/**
 * Greets a peer up to the point where it is to be taken or refused.
 *
 * @throws ZmtpError when it does not speak ZMTP, or has a socket of another type; SourceEnded
 */
export async function greetPeer(
  socket: Socket,
  source: ByteSource,
  { own, accepted }: OwnEnd,
): Promise<ZmtpPeer> {
  socket.write(OPENING);
  const version = readOpening(await source.take(OPENING_BYTES));
  const properties = version === 3 ? await readV3(socket, source) : await readV2(source);
  const peer = new ZmtpPeer(version, own, properties.identity);
  if (!accepted.some((type) => type === properties.socketType)) {
    const reason = `A ${own} of the master takes ${accepted.join(' and ')} sockets only.`;
    socket.end(peer.refusal(reason));
    throw new ZmtpError(reason);
  }
  return peer;
}

async function readV3(socket: Socket, source: ByteSource): Promise<PeerProperties> {
  socket.write(REST_OF_GREETING);
  checkRestOfGreeting(await source.take(REST_OF_GREETING_BYTES));
  const { isCommand, body } = await readFrame(source, MAX_PROPERTIES_BYTES);
  const { name, data } = isCommand ? readCommand(body) : { name: '', data: body };
  if (name !== 'READY') throw new ZmtpError('The peer does not begin with READY.');
  return readReady(data);
}

async function readV2(source: ByteSource): Promise<PeerProperties> {
  const [type = 0] = await source.take(1);
  const { isCommand, hasMore, body } = await readFrame(source, MAX_IDENTITY_BYTES);
  if (isCommand || hasMore) throw new ZmtpError('The peer does not begin with its identity.');
  return { socketType: socketTypeOf(type) ?? '', identity: body };
}
