import type { Image2D } from '@ubii/proto';

/** Largest memory of all held pictures, bytes; the oldest are evicted. */
const MAX_BYTES = 24_000_000;
/** Most pictures held. */
const MAX_PICTURES = 64;

/** Sent pictures, held until their results arrive. */
export class HeldPictures {
  #pictures = new Map<number, Image2D>();
  #bytes = 0;

  /** @param takenMs timestamp of its record */
  add(takenMs: number, picture: Image2D): void {
    this.#pictures.set(Math.round(takenMs), picture);
    this.#bytes += picture.data.length;
    for (const [oldest, { data }] of this.#pictures) {
      if (this.#bytes <= MAX_BYTES && this.#pictures.size <= MAX_PICTURES) return;
      this.#pictures.delete(oldest);
      this.#bytes -= data.length;
    }
  }

  /** Returns the picture with this timestamp; undefined when it is no longer held. */
  at(takenMs: number): Image2D | undefined {
    return this.#pictures.get(Math.round(takenMs));
  }

  clear(): void {
    this.#pictures.clear();
    this.#bytes = 0;
  }
}
