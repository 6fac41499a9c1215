/** Makes of a batch what an adapter writes. */
export interface BatchEncoder<T> {
  encode(batch: RecordBatch): T;
}

/**
 * Records that leave together, in publishing order. One batch is handed to every connection that is
 * sent exactly these records, so what is made of it should be made once: see `memo`.
 */
export interface RecordBatch {
  /** At least one encoded `TopicDataRecord` each. Shared and kept by the master: never write to them. */
  readonly records: readonly Uint8Array[];
  /** Number of records. */
  readonly count: number;
  /** Sum of the records' lengths, bytes. */
  readonly byteLength: number;
  /** Returns the encoded batch. The first call encodes it; all other connections share the result. */
  memo<T>(encoder: BatchEncoder<T>): T;
}
