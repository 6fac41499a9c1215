import { once } from 'node:events';
import type { Socket } from 'node:net';

import type { Member, Outsider } from '../../master/outsider.ts';

/** Not zero: the master has to unmask what comes. */
const MASK = Buffer.of(0x5a, 0xa5, 0x3c, 0xc3);

/** One WebSocket frame as a client sends it, to be sent again and again. */
export function clientFrame(payload: Uint8Array): Buffer {
  const head = Buffer.alloc(14);
  head[0] = 0x82;
  head[1] = 0x80 | 127;
  head.writeBigUInt64BE(BigInt(payload.length), 2);
  MASK.copy(head, 10);
  const masked = Buffer.from(payload);
  for (let i = 0; i < masked.length; i++) masked[i]! ^= MASK[i & 3]!;
  return Buffer.concat([head, masked]);
}

/** A player whose program sends one frame after the other, as fast as the master reads. */
export class FrameFlood {
  readonly #socket: Socket;
  #isOver = false;
  #frames = 0;
  #receivedBytes = 0;

  private constructor(socket: Socket) {
    this.#socket = socket;
    socket.on('data', (chunk: Buffer) => (this.#receivedBytes += chunk.length));
  }

  /** @throws Error when the master does not open the socket */
  static async open(outsider: Outsider, { client }: Member): Promise<FrameFlood> {
    const socket = await outsider.dial();
    const token = client.extension?.resumeToken ?? '';
    const upgrade = {
      Connection: 'Upgrade',
      Upgrade: 'websocket',
      'Sec-WebSocket-Version': '13',
      'Sec-WebSocket-Key': Buffer.from('a key of an attack').toString('base64').slice(0, 22) + '==',
    };
    socket.write(outsider.head(`GET /?clientID=${client.id}&token=${token} HTTP/1.1`, upgrade));
    const [answer] = (await once(socket, 'data')) as [Buffer];
    if (!answer.toString('latin1').startsWith('HTTP/1.1 101')) {
      throw new Error(`The socket was refused: ${answer.toString('latin1').slice(0, 200)}`);
    }
    return new FrameFlood(socket);
  }

  /** Frames that were written. */
  get frames(): number {
    return this.#frames;
  }

  /** Bytes of what the master answered. */
  get receivedBytes(): number {
    return this.#receivedBytes;
  }

  get isOpen(): boolean {
    return !this.#socket.destroyed;
  }

  /** Sends until it is stopped. */
  async send(frame: Buffer): Promise<void> {
    while (!this.#isOver && !this.#socket.destroyed) {
      this.#frames++;
      if (!this.#socket.write(frame)) await this.#drained();
    }
  }

  /** Waits until the socket takes more, or is closed. */
  #drained(): Promise<void> {
    return new Promise((resolve) => {
      const handle = (): void => {
        this.#socket.off('drain', handle).off('close', handle);
        resolve();
      };
      this.#socket.once('drain', handle).once('close', handle);
    });
  }

  close(): void {
    this.#isOver = true;
    this.#socket.destroy();
  }
}
