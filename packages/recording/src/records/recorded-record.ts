/** A record as it was published, with the times at which that happened. */
export interface RecordedRecord {
  readonly topic: string;
  /** Client id of the publisher; empty for the master. */
  readonly clientId: string;
  /** The encoded `ubii.topicData.TopicDataRecord`, bit for bit. In files of other programs: the message as it is. */
  readonly record: Uint8Array;
  /** When the record reached the recorder, nanoseconds since the Unix epoch. */
  readonly logTimeNs: bigint;
  /** When the value was taken, by the publisher's clock; `logTimeNs` when that is not known. Nanoseconds since the Unix epoch. */
  readonly publishTimeNs: bigint;
  /** Of a message of another program: how its file describes it. Undefined for a `TopicDataRecord`. */
  readonly foreign?: ForeignChannel | undefined;
}

/** A channel of another program: one object for all its messages. */
export interface ForeignChannel {
  /** Undefined for messages without one. */
  readonly schema:
    | { readonly name: string; readonly encoding: string; readonly data: Uint8Array }
    | undefined;
  /** Such as `cdr` or `json`. */
  readonly messageEncoding: string;
  readonly metadata: ReadonlyMap<string, string>;
}
