/** Where a recording is read from. */
export interface RecordingSource {
  /** Bytes. */
  size(): Promise<bigint>;
  /**
   * Reads bytes.
   *
   * @returns exactly `length` bytes, which the caller owns
   * @throws RecordingError when the file has fewer, or when they are too many for one read [RC-43]
   */
  read(offset: bigint, length: bigint): Promise<Uint8Array>;
}

/** Where a recording is written to. Calls never overlap. */
export interface RecordingSink {
  /** Appends bytes; the caller may reuse them when the promise is fulfilled. On failure none is kept. */
  write(bytes: Uint8Array): Promise<void>;
  /** Bytes written so far: where the next ones go. */
  position(): bigint;
}

/** A file that can be read, shortened and appended to: for repair and for changes after the end. */
export interface RecordingFile extends RecordingSource, RecordingSink {
  /** Drops everything from `length` on; `position()` is `length` then. */
  truncate(length: bigint): Promise<void>;
}
