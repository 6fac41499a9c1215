import type { DataFormat } from '@ubii/proto';

/** What the recorder has to know of an encoded record. */
export interface RecordDescription {
  /** Data format of the value; undefined for a record without value. */
  readonly format: DataFormat | undefined;
  /** Source time, milliseconds since the Unix epoch; undefined when the record has none that is plausible. */
  readonly timestampMs: number | undefined;
}

/** Reads format and time of an encoded record without decoding its value. Never throws: broken records have neither. */
export declare function describeRecord(record: Uint8Array): RecordDescription;
