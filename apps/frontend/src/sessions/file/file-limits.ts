const MIB = 1024 * 1024;

/** What is read of files at all, and why not more. */
export const FILE_LIMITS = {
  /**
   * Bytes of one file. The master takes 8 MiB of an encoded session; as JSON, with the source of its
   * modules escaped and places beside it, that is at most about three times as much.
   */
  bytes: 24 * MIB,
  /**
   * Bytes that are read in the page itself; more goes to a worker, so that nothing stands still. This
   * much takes some milliseconds on a slow tablet.
   */
  bytesInPage: 128 * 1024,
  /** Modules of one session: the master takes no more. */
  modules: 256,
  /** Inputs and outputs mapped in one session: the master takes no more. */
  mappings: 4_096,
  /** Characters that a text may have to be edited by hand; editors of text get slow beyond. */
  textToEdit: 1_000_000,
} as const;
