import { constants } from 'node:fs';
import { open, type FileHandle } from 'node:fs/promises';
import { RecordingError } from '../records/recording-error.ts';
import { expectReadable } from '../storage/reading-limits.ts';
import type { RecordingFile } from '../storage/recording-storage.ts';

/** A recording on disk. */
export class DiskFile implements RecordingFile {
  readonly #handle: FileHandle;
  #position: bigint;

  private constructor(handle: FileHandle, position: bigint) {
    this.#handle = handle;
    this.#position = position;
  }

  /** For reading. */
  static async open(path: string): Promise<DiskFile> {
    return new DiskFile(await open(path, 'r'), 0n);
  }

  /**
   * For writing; `position()` is 0.
   *
   * @param mode of the file, before the mask of the process
   * @throws when the file exists
   */
  static async create(path: string, mode = 0o666): Promise<DiskFile> {
    return new DiskFile(await open(path, 'wx+', mode), 0n);
  }

  /** For repair and changes; `position()` is the end. */
  static async edit(path: string): Promise<DiskFile> {
    const handle = await open(path, constants.O_RDWR);
    return new DiskFile(handle, (await handle.stat({ bigint: true })).size);
  }

  async size(): Promise<bigint> {
    return (await this.#handle.stat({ bigint: true })).size;
  }

  async read(offset: bigint, length: bigint): Promise<Uint8Array> {
    expectReadable(offset, length, await this.size());
    const bytes = new Uint8Array(Number(length));
    for (let done = 0; done < bytes.length;) {
      const position = Number(offset) + done;
      const { bytesRead } = await this.#handle.read(bytes, done, bytes.length - done, position);
      if (bytesRead === 0) throw new RecordingError('The file ends before these bytes.');
      done += bytesRead;
    }
    return bytes;
  }

  async write(bytes: Uint8Array): Promise<void> {
    try {
      for (let done = 0; done < bytes.length;) {
        const position = Number(this.#position) + done;
        const length = bytes.length - done;
        done += (await this.#handle.write(bytes, done, length, position)).bytesWritten;
      }
    } catch (error) {
      await this.#handle.truncate(Number(this.#position));
      throw error;
    }
    this.#position += BigInt(bytes.length);
  }

  position(): bigint {
    return this.#position;
  }

  async truncate(length: bigint): Promise<void> {
    await this.#handle.truncate(Number(length));
    this.#position = length;
  }

  /** Waits until the disk has what was written. */
  sync(): Promise<void> {
    return this.#handle.datasync();
  }

  close(): Promise<void> {
    return this.#handle.close();
  }
}
