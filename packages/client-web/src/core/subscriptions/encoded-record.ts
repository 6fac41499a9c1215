/** An encoded record, to forward it or to decode it elsewhere. */
export interface EncodedRecord {
  readonly topic: string;
  /** The encoded `TopicDataRecord`. It is not modified, and may be kept. */
  readonly bytes: Uint8Array;
  /** Number of the value member. */
  readonly valueField: number;
  /** Id of the client that published it; empty if the record does not name it. */
  readonly publisherId: string;
  /** True: the buffer of `bytes` is not shared, so that it may be transferred to a worker. */
  readonly isOwned: boolean;
}

/** Takes the records of an encoded subscription. */
export interface EncodedListener {
  onRecord(record: EncodedRecord): void;
  /** The topic no longer has a value. [TD-42] */
  onGone(topic: string): void;
}
