import type { Image2D } from '@ubii/proto';

/** Of all held pictures, bytes; the oldest are evicted. */
const MAX_BYTES = 24_000_000;
/** Results are expected for no more than these. */
const MAX_PICTURES = 64;

/** The last pictures that were sent, until their results come. */
export class HeldPictures {
  #pictures = new Map<number, Image2D>();
  #bytes = 0;

  /** @param takenMs the timestamp with which it is published */
  add(takenMs: number, picture: Image2D): void {
    this.#pictures.set(Math.round(takenMs), picture);
    this.#bytes += picture.data.length;
    for (const [oldest, { data }] of this.#pictures) {
      if (this.#bytes <= MAX_BYTES && this.#pictures.size <= MAX_PICTURES) return;
      this.#pictures.delete(oldest);
      this.#bytes -= data.length;
    }
  }

  /** The picture with this timestamp; undefined when it is not held any more. */
  at(takenMs: number): Image2D | undefined {
    return this.#pictures.get(Math.round(takenMs));
  }

  clear(): void {
    this.#pictures.clear();
    this.#bytes = 0;
  }
}
