import { expectReadable } from '../storage/expect-readable.ts';
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
    expectReadable(offset, length, BigInt(this.#blob.size));
    const slice = this.#blob.slice(Number(offset), Number(offset + length));
    return new Uint8Array(await slice.arrayBuffer());
  }
}
