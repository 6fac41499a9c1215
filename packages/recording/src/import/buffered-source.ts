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
      this.#window = await this.#source.read(BigInt(offset), BigInt(Math.max(0, ahead)));
      this.#offset = offset;
    }
    return this.#window.subarray(offset - this.#offset, offset - this.#offset + wanted);
  }
}
