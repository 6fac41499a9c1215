/** From this size on, handing over a buffer costs less than copying it. */
const MIN_TRANSFER_BYTES = 4096;

/**
 * Brings the bytes of a batch of messages over without a copy more than needed: owned buffers are
 * transferred, all others copied into one that is. [PM-36]
 */
export class BytePacker {
  /** Arrays and the place in them where the bytes belong, alternately. */
  readonly #holders: unknown[][] = [];
  readonly #places: number[] = [];
  readonly #transfer: ArrayBuffer[] = [];
  #sizeBytes = 0;

  /**
   * Takes the bytes at a place of an array; `pack` puts there what travels.
   *
   * @param isOwned the buffer of the bytes is not shared
   */
  add(holder: unknown[], place: number, isOwned: boolean): void {
    const bytes = holder[place] as Uint8Array;
    const isWhole = bytes.byteLength === bytes.buffer.byteLength;
    if (isOwned && isWhole && bytes.byteLength >= MIN_TRANSFER_BYTES) {
      this.#transfer.push(bytes.buffer as ArrayBuffer);
      return;
    }
    this.#holders.push(holder);
    this.#places.push(place);
    this.#sizeBytes += bytes.byteLength;
  }

  /** Packs what was added since the call before. @returns what to transfer */
  pack(): ArrayBuffer[] {
    const transfer = this.#transfer.splice(0);
    if (this.#holders.length > 0) {
      const all = new Uint8Array(this.#sizeBytes);
      let start = 0;
      for (let i = 0; i < this.#holders.length; i++) {
        const holder = this.#holders[i]!;
        const place = this.#places[i]!;
        const bytes = holder[place] as Uint8Array;
        all.set(bytes, start);
        holder[place] = all.subarray(start, start + bytes.byteLength);
        start += bytes.byteLength;
      }
      if (this.#sizeBytes >= MIN_TRANSFER_BYTES) transfer.push(all.buffer);
      this.#holders.length = 0;
      this.#places.length = 0;
    }
    this.#sizeBytes = 0;
    return transfer;
  }
}
