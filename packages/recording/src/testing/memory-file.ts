import { expectReadable } from '../storage/reading-limits.ts';
import type { RecordingFile } from '../storage/recording-storage.ts';

/** A recording in memory, which counts what is read. */
export class MemoryFile implements RecordingFile {
  #bytes = new Uint8Array(1024);
  #length = 0;
  /** Bytes that `read` returned so far. */
  readBytes = 0;
  /** Calls of `read` so far. */
  reads = 0;
  /** Writes beyond this many bytes fail, as on a full disk. */
  maxBytes = Infinity;

  constructor(content: Uint8Array = new Uint8Array()) {
    this.#append(content);
  }

  /** A copy of what was written. */
  get bytes(): Uint8Array<ArrayBuffer> {
    return this.#bytes.slice(0, this.#length);
  }

  size(): Promise<bigint> {
    return Promise.resolve(BigInt(this.#length));
  }

  async read(offset: bigint, length: bigint): Promise<Uint8Array> {
    expectReadable(offset, length, await this.size());
    this.readBytes += Number(length);
    this.reads += 1;
    return this.#bytes.slice(Number(offset), Number(offset + length));
  }

  write(bytes: Uint8Array): Promise<void> {
    if (this.#length + bytes.length > this.maxBytes) {
      return Promise.reject(new Error('ENOSPC: no space left on device, write'));
    }
    this.#append(bytes);
    return Promise.resolve();
  }

  position(): bigint {
    return BigInt(this.#length);
  }

  truncate(length: bigint): Promise<void> {
    this.#length = Number(length);
    return Promise.resolve();
  }

  #append(bytes: Uint8Array): void {
    const length = this.#length + bytes.length;
    if (length > this.#bytes.length) {
      const larger = new Uint8Array(Math.max(length, this.#bytes.length * 2));
      larger.set(this.#bytes.subarray(0, this.#length));
      this.#bytes = larger;
    }
    this.#bytes.set(bytes, this.#length);
    this.#length = length;
  }
}
