import { READING_LIMITS } from '../storage/reading-limits.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';

const WINDOW_BYTES = 1024 * 1024;

/** Reads a source ahead, for many small reads one after the other. */
export class BufferedSource {
  readonly size: number;
  readonly #source: RecordingSource;
  #window: Uint8Array = new Uint8Array(0);
  #offset = 0;

  private constructor(source: RecordingSource, size: number) {
    this.#source = source;
    this.size = size;
  }

  static async open(source: RecordingSource): Promise<BufferedSource> {
    return new BufferedSource(source, Number(await source.size()));
  }

  /** The bytes from `offset` on, at most `length`; fewer at the end of the file. They are valid until the next call. */
  async read(offset: number, length: number): Promise<Uint8Array> {
    const wanted = Math.max(0, Math.min(length, this.size - offset));
    const isHeld =
      offset >= this.#offset && offset + wanted <= this.#offset + this.#window.byteLength;
    if (!isHeld) {
      const ahead = Math.min(Math.max(wanted, WINDOW_BYTES), this.size - offset);
      this.#window = await this.#readAll(offset, Math.max(0, ahead));
      this.#offset = offset;
    }
    return this.#window.subarray(offset - this.#offset, offset - this.#offset + wanted);
  }

  /** Reads bytes, with as many reads as they need. */
  async #readAll(offset: number, length: number): Promise<Uint8Array> {
    const { readBytes } = READING_LIMITS;
    if (length <= readBytes) return this.#source.read(BigInt(offset), BigInt(length));
    const bytes = new Uint8Array(length);
    for (let done = 0; done < length; done += readBytes) {
      const part = Math.min(readBytes, length - done);
      bytes.set(await this.#source.read(BigInt(offset + done), BigInt(part)), done);
    }
    return bytes;
  }
}
