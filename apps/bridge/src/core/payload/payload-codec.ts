import type { DataFormat } from '@ubii/proto';
import type { Mapping } from '../mapping/mapping.ts';

/** A value of a topic. */
export interface TypedValue {
  readonly format: DataFormat;
  /** Of the type that `DataFormatValues` gives the format. */
  readonly value: unknown;
  /** When the value was taken, milliseconds since the Unix epoch; `undefined`: now. */
  readonly timestampMs?: number | undefined;
}

/** A record of the master that goes to the other system. */
export interface OutgoingRecord extends TypedValue {
  readonly topic: string;
  /** The encoded `TopicDataRecord`. */
  readonly bytes: Uint8Array;
}

/** Converts between the messages of one kind of system and the values of topics. */
export interface PayloadCodec<P> {
  /** @throws Error with the reason when the message is not what the mapping says */
  read(payload: P, mapping: Mapping): TypedValue;
  /** @throws Error with the reason when the value does not fit the message */
  write(record: OutgoingRecord, mapping: Mapping): P;
}
