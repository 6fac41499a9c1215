import type { RecordingSource } from '../storage/recording-storage.ts';

/** Reads a file that the user chose, or any other `Blob`. */
export class BlobSource implements RecordingSource {
  readonly #blob: Blob;

  constructor(blob: Blob) {
    this.#blob = blob;
  }

  size(): Promise<bigint> {
    return Promise.resolve(BigInt(this.#blob.size));
  }

  async read(offset: bigint, length: bigint): Promise<Uint8Array> {
    const slice = this.#blob.slice(Number(offset), Number(offset + length));
    if (slice.size !== Number(length)) throw new RangeError('The file ends before these bytes.');
    return new Uint8Array(await slice.arrayBuffer());
  }
}
