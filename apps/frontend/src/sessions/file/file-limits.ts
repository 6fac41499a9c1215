const MIB = 1024 * 1024;

/** Limits for reading files. */
export const FILE_LIMITS = {
  /**
   * Largest file, bytes. The master accepts 8 MiB of an encoded session; as JSON, with escaped sources and positions,
   * that is at most about three times as much.
   */
  bytes: 24 * MIB,
  /**
   * Largest file that is parsed on the main thread, bytes: some milliseconds on a slow tablet. Larger ones are parsed
   * in a worker.
   */
  bytesInPage: 128 * 1024,
  /** Most modules per session that the master accepts. */
  modules: 256,
  /** Most mapped inputs and outputs per session that the master accepts. */
  mappings: 4_096,
  /** Longest text for manual editing, characters; text editors are slow beyond. */
  textToEdit: 1_000_000,
} as const;
