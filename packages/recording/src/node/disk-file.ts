import type { RecordingFile } from '../storage/recording-storage.ts';

/** A recording on disk. */
export declare class DiskFile implements RecordingFile {
  /** For reading. */
  static open(path: string): Promise<DiskFile>;
  /** For writing; `position()` is 0. @throws when the file exists */
  static create(path: string): Promise<DiskFile>;
  /** For repair and changes; `position()` is the end. */
  static edit(path: string): Promise<DiskFile>;
  size(): Promise<bigint>;
  read(offset: bigint, length: bigint): Promise<Uint8Array>;
  write(bytes: Uint8Array): Promise<void>;
  position(): bigint;
  truncate(length: bigint): Promise<void>;
  /** Waits until the disk has what was written. */
  sync(): Promise<void>;
  close(): Promise<void>;
}
