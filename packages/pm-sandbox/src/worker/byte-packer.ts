/** Something that holds bytes which are to travel. */
export interface ByteHolder {
  bytes: Uint8Array;
}

/** From this size on, bytes that need not be kept travel in their own buffer. */
const MIN_TRANSFER_BYTES = 4096;

/**
 * Brings the bytes of a batch of messages over without a copy more than needed: owned buffers are
 * transferred, all others copied into one that is. [PM-36]
 */
export class BytePacker {
  readonly #packed: ByteHolder[] = [];
  readonly #transfer: ArrayBuffer[] = [];
  #sizeBytes = 0;

  /** @param isOwned nobody else reads the buffer of the bytes */
  add(holder: ByteHolder, isOwned: boolean): void {
    const { bytes } = holder;
    const isWhole = bytes.byteLength === bytes.buffer.byteLength;
    if (isOwned && isWhole && bytes.byteLength >= MIN_TRANSFER_BYTES) {
      this.#transfer.push(bytes.buffer as ArrayBuffer);
      return;
    }
    this.#packed.push(holder);
    this.#sizeBytes += bytes.byteLength;
  }

  /** Packs what was added since the call before. @returns what to transfer */
  pack(): ArrayBuffer[] {
    const transfer = this.#transfer.splice(0);
    if (this.#packed.length > 0) {
      const all = new Uint8Array(this.#sizeBytes);
      let start = 0;
      for (const holder of this.#packed.splice(0)) {
        const end = start + holder.bytes.byteLength;
        all.set(holder.bytes, start);
        holder.bytes = all.subarray(start, end);
        start = end;
      }
      // Handing over a small buffer costs more than copying it once more.
      if (this.#sizeBytes >= MIN_TRANSFER_BYTES) transfer.push(all.buffer);
    }
    this.#sizeBytes = 0;
    return transfer;
  }
}
