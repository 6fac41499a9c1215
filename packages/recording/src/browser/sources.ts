import { LruCache } from '../reading/lru-cache.ts';
import { RecordingError } from '../records/recording-error.ts';
import { expectReadable } from '../storage/reading-limits.ts';
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

/** Small reads get the block around them: magic, header and metadata lie together, and events in small chunks. */
const BLOCK_BYTES = 16n * 1024n;
const SMALL_BYTES = 4n * 1024n;
const KEPT_BLOCKS = 16;

type Fetch = (url: string, init: RequestInit) => Promise<Response>;

/** Reads a file from a server that answers requests for ranges. The file must not change meanwhile. */
export class RangeSource implements RecordingSource {
  readonly #url: string;
  readonly #fetch: Fetch;
  #size: Promise<bigint> | undefined;
  #etag: string | null = null;
  readonly #blocks = new LruCache<Uint8Array>(KEPT_BLOCKS);

  /** @param fetch sends the requests. @default the browser's */
  constructor(url: string, fetch: Fetch = (address, init) => globalThis.fetch(address, init)) {
    this.#url = url;
    this.#fetch = fetch;
  }

  size(): Promise<bigint> {
    this.#size ??= this.#readSize();
    return this.#size;
  }

  async read(offset: bigint, length: bigint): Promise<Uint8Array> {
    const size = await this.size();
    expectReadable(offset, length, size);
    if (length === 0n) return new Uint8Array();
    const start = (offset / BLOCK_BYTES) * BLOCK_BYTES;
    const end = start + BLOCK_BYTES < size ? start + BLOCK_BYTES : size;
    if (length > SMALL_BYTES || offset + length > end) return this.#fetchRange(offset, length);
    const block = await this.#blocks.get(start, 1, () => this.#fetchRange(start, end - start));
    return block.slice(Number(offset - start), Number(offset - start + length));
  }

  async #fetchRange(offset: bigint, length: bigint): Promise<Uint8Array> {
    const range = `bytes=${offset}-${offset + length - 1n}`;
    const response = await this.#fetch(this.#url, { headers: { Range: range } });
    if (response.status !== 206) throw this.#refused(response);
    if (response.headers.get('ETag') !== this.#etag) {
      throw new RecordingError('The recording was changed. Open it again.');
    }
    const bytes = new Uint8Array(await response.arrayBuffer());
    if (bytes.length !== Number(length)) {
      throw new RecordingError('The file ends before these bytes.');
    }
    return bytes;
  }

  async #readSize(): Promise<bigint> {
    const response = await this.#fetch(this.#url, { method: 'HEAD' });
    const length = response.headers.get('Content-Length');
    if (!response.ok || length === null) throw this.#refused(response);
    this.#etag = response.headers.get('ETag');
    return BigInt(length);
  }

  #refused({ status, statusText }: Response): RecordingError {
    return new RecordingError(`The master answered ${status} ${statusText}.`);
  }
}
