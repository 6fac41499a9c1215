import { Zip, ZipDeflate, ZipPassThrough } from 'fflate';

/** Where the bytes of one file go. */
export interface Output {
  /** @param position where in the file, bytes; at the end by default */
  write(bytes: Uint8Array, position?: number): Promise<void>;
}

/** The file that is saved. */
export interface SavedFile extends Output {
  /** @returns the file, unless it was written to a handle */
  end(): Promise<Blob | undefined>;
  /** Leaves nothing behind. */
  abort(): Promise<void>;
}

/** A file without a handle is kept in memory, at most this much, bytes. */
export const MAX_MEMORY_BYTES = 1024 ** 3;

/** Writes to a file that the user chose. */
export async function openHandle(handle: FileSystemFileHandle): Promise<SavedFile> {
  const stream = await handle.createWritable();
  return {
    write: (bytes, position) => {
      const data = bytes as Uint8Array<ArrayBuffer>;
      return stream.write(position === undefined ? data : { type: 'write', position, data });
    },
    async end() {
      await stream.close();
      return undefined;
    },
    abort: () => stream.abort(),
  };
}

/** A part of a file in memory that the browser may move to disk, bytes. */
const PART_BYTES = 16 * 1024 * 1024;

/** Keeps a file in memory. It is written from its beginning to its end. */
export function openMemory(maxBytes = MAX_MEMORY_BYTES): SavedFile {
  const whole: Blob[] = [];
  let part: Uint8Array<ArrayBuffer>[] = [];
  let [partBytes, bytesSoFar] = [0, 0];
  const closePart = (): void => {
    whole.push(new Blob(part));
    [part, partBytes] = [[], 0];
  };
  return {
    write(bytes, position) {
      if (position !== undefined && position !== bytesSoFar) {
        return Promise.reject(new Error('A file in memory is written in order.'));
      }
      bytesSoFar += bytes.byteLength;
      if (bytesSoFar > maxBytes) {
        return Promise.reject(
          new Error(
            `The file has more than ${Math.round(maxBytes / 1024 ** 2)} MB, which this browser would keep in memory. Choose fewer topics or a shorter span.`,
          ),
        );
      }
      part.push(bytes.slice());
      partBytes += bytes.byteLength;
      if (partBytes >= PART_BYTES) closePart();
      return Promise.resolve();
    },
    end() {
      closePart();
      return Promise.resolve(new Blob(whole));
    },
    abort: () => Promise.resolve(),
  };
}

/** A ZIP file has no larger offsets. */
const MAX_ZIP_BYTES = 0xffff_ffff;

/** Several files in one ZIP, one after the other. */
export class ZipFile {
  readonly #target: Output;
  readonly #zip: Zip;
  readonly #pending: Uint8Array[] = [];
  #bytes = 0;
  #failure: Error | undefined;

  constructor(target: Output) {
    this.#target = target;
    this.#zip = new Zip((error, part) => {
      if (error) this.#failure = error;
      else this.#pending.push(part);
    });
  }

  /** Adds a file; the one before must have ended. @param isPacked it is compressed already */
  add(name: string, isPacked: boolean): Output & { end(): Promise<void> } {
    const entry = isPacked ? new ZipPassThrough(name) : new ZipDeflate(name, { level: 6 });
    this.#zip.add(entry);
    return {
      write: (bytes) => {
        // The packer may keep what it gets.
        entry.push(bytes.slice());
        return this.#flush();
      },
      end: () => {
        entry.push(new Uint8Array(0), true);
        return this.#flush();
      },
    };
  }

  end(): Promise<void> {
    this.#zip.end();
    return this.#flush();
  }

  async #flush(): Promise<void> {
    for (let part = this.#pending.shift(); part; part = this.#pending.shift()) {
      this.#bytes += part.byteLength;
      if (this.#bytes > MAX_ZIP_BYTES) {
        throw new Error('The ZIP file has more than 4 GB. Export fewer topics or a shorter span.');
      }
      await this.#target.write(part);
    }
    if (this.#failure) throw this.#failure;
  }
}
