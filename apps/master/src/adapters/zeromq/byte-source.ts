import type { Socket } from 'node:net';

/** While so many bytes wait, nothing more is read from the socket. */
const MAX_WAITING_BYTES = 64 * 1024;

/** The connection closed before all that was asked for had come. */
export class SourceEnded extends Error {
  override readonly name = 'SourceEnded';
}

interface Demand {
  readonly least: number;
  readonly resolve: () => void;
  readonly reject: (error: Error) => void;
}

/** Reads a socket on demand, one reader at a time. Bytes that no reader asks for stay in the buffers of the system. */
export class ByteSource {
  readonly #socket: Socket;
  #chunks: Buffer[] = [];
  #waitingBytes = 0;
  #demand: Demand | undefined;
  #hasEnded = false;

  constructor(socket: Socket) {
    this.#socket = socket;
    socket.on('data', this.#handleData);
    socket.on('end', this.#handleEnd);
    socket.on('close', this.#handleEnd);
  }

  /** Returns the next bytes without taking them, at least `least`. @throws SourceEnded */
  async peek(least: number): Promise<Buffer> {
    await this.#has(least);
    return this.#join();
  }

  /** Takes exactly so many bytes. @throws SourceEnded */
  async take(size: number): Promise<Buffer> {
    await this.#has(size);
    return this.#takeWaiting(size);
  }

  /** Takes what is there of the next `most` bytes, at least one. @throws SourceEnded */
  async takeSome(most: number): Promise<Buffer> {
    await this.#has(1);
    return this.#takeWaiting(Math.min(most, this.#waitingBytes));
  }

  /** Stops reading: the socket is paused, and others may read it. @returns what was read and not taken */
  release(): Buffer {
    this.#socket.off('data', this.#handleData);
    this.#socket.off('end', this.#handleEnd);
    this.#socket.off('close', this.#handleEnd);
    this.#socket.pause();
    return this.#takeWaiting(this.#waitingBytes);
  }

  readonly #handleData = (chunk: Buffer): void => {
    this.#chunks.push(chunk);
    this.#waitingBytes += chunk.length;
    const demand = this.#demand;
    if (demand !== undefined && this.#waitingBytes >= demand.least) {
      this.#demand = undefined;
      demand.resolve();
    } else if (demand === undefined && this.#waitingBytes >= MAX_WAITING_BYTES) {
      this.#socket.pause();
    }
  };

  readonly #handleEnd = (): void => {
    this.#hasEnded = true;
    this.#demand?.reject(new SourceEnded());
    this.#demand = undefined;
  };

  #has(least: number): Promise<void> {
    if (this.#waitingBytes >= least) return Promise.resolve();
    if (this.#hasEnded || this.#socket.destroyed) return Promise.reject(new SourceEnded());
    this.#socket.resume();
    return new Promise((resolve, reject) => {
      this.#demand = { least, resolve, reject };
    });
  }

  #takeWaiting(size: number): Buffer {
    const joined = this.#join();
    this.#chunks = [joined.subarray(size)];
    this.#waitingBytes -= size;
    return joined.subarray(0, size);
  }

  #join(): Buffer {
    if (this.#chunks.length > 1) this.#chunks = [Buffer.concat(this.#chunks)];
    return this.#chunks[0] ?? Buffer.alloc(0);
  }
}
