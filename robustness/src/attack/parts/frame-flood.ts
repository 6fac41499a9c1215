import { once } from 'node:events';
import type { Socket } from 'node:net';
import type { Member, Outsider } from '@ubii/harness';

import { pause } from '../../pause.ts';

/** Not zero: the master has to unmask what comes. */
const MASK = Buffer.of(0x5a, 0xa5, 0x3c, 0xc3);
const KEY = Buffer.alloc(16).toString('base64');
/** Between the end of a connection and the next, milliseconds. */
const REST_MS = 20;

/** Small frames are written together: the attack is to be busy with sending alone. */
const WRITE_BYTES = 256 * 1024;

/** WebSocket frames as a client sends them, one or several small ones, to be sent again and again. */
export function clientFrames(payload: Uint8Array): Buffer {
  const head = Buffer.alloc(14);
  head[0] = 0x82;
  head[1] = 0x80 | 127;
  head.writeBigUInt64BE(BigInt(payload.length), 2);
  MASK.copy(head, 10);
  const masked = Buffer.from(payload);
  for (let i = 0; i < masked.length; i++) masked[i]! ^= MASK[i & 3]!;
  const frame = Buffer.concat([head, masked]);
  return Buffer.alloc(frame.length * Math.ceil(WRITE_BYTES / frame.length), frame);
}

/** A client that sends the same frames, as fast as the master reads, and comes back when it is closed. */
export class FrameFlood {
  readonly #outsider: Outsider;
  readonly #member: Member;
  #socket: Socket | undefined = undefined;
  #isOver = false;
  #connections = 0;
  #sentBytes = 0;

  constructor(outsider: Outsider, member: Member) {
    this.#outsider = outsider;
    this.#member = member;
  }

  get connections(): number {
    return this.#connections;
  }

  /** Bytes that the system took. */
  get sentBytes(): number {
    return this.#sentBytes + (this.#socket?.bytesWritten ?? 0);
  }

  /** Sends until it is closed. @throws Error when the first connection is refused */
  async send(frames: Buffer): Promise<void> {
    while (!this.#isOver) {
      const socket = await this.#open();
      while (!socket.destroyed) if (!socket.write(frames)) await drained(socket);
      this.#socket = undefined;
      this.#sentBytes += socket.bytesWritten;
      await pause(REST_MS);
    }
  }

  close(): void {
    this.#isOver = true;
    this.#socket?.destroy();
  }

  async #open(): Promise<Socket> {
    const { id, extension } = this.#member.client;
    const socket = await this.#outsider.dial();
    const upgrade = {
      Connection: 'Upgrade',
      Upgrade: 'websocket',
      'Sec-WebSocket-Version': '13',
      'Sec-WebSocket-Key': KEY,
    };
    const path = `/?clientID=${id}&token=${extension?.resumeToken ?? ''}`;
    socket.write(this.#outsider.head(`GET ${path} HTTP/1.1`, upgrade));
    const [answer] = (await once(socket, 'data')) as [Buffer];
    const start = answer.toString('latin1', 0, 12);
    if (start !== 'HTTP/1.1 101') throw new Error(`The socket was refused: ${start}`);
    this.#connections++;
    this.#socket = socket;
    // What the master says is of no interest; unread, it would fill its buffers.
    return socket.resume();
  }
}

/** Waits until the socket takes more, or is closed. */
function drained(socket: Socket): Promise<void> {
  return new Promise((resolve) => {
    const handle = (): void => {
      socket.off('drain', handle).off('close', handle);
      resolve();
    };
    socket.once('drain', handle).once('close', handle);
  });
}
