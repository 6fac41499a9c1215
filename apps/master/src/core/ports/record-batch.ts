/**
 * Records that leave together, in publishing order. One batch is handed to every connection that is
 * owed exactly these records, so what is made of it should be made once: see `memo`.
 */
export interface RecordBatch {
  /** At least one encoded `TopicDataRecord` each. Shared and kept by the master: never write to them. */
  readonly records: readonly Uint8Array[];
  /** Sum of the records' lengths, bytes. */
  readonly byteLength: number;
  /**
   * What `make` returned the first time this batch was asked with this `key` (compared by identity).
   * An encoder uses itself as the key and gets its frame bytes made once for all connections.
   */
  memo<T>(key: object, make: () => T): T;
}
