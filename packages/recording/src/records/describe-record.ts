import { dataFormatOfField, type DataFormat } from '@ubii/proto';
import { readRecordHead, readRecordTimestamp } from '@ubii/proto/wire';

/** What the recorder has to know of an encoded record. */
export interface RecordDescription {
  /** Data format of the value; undefined for a record without value. */
  readonly format: DataFormat | undefined;
  /** Source time, milliseconds since the Unix epoch; undefined when the record has none that is plausible. */
  readonly timestampMs: number | undefined;
}

/** Reads format and time of an encoded record without decoding its value. Never throws: broken records have neither. */
export function describeRecord(record: Uint8Array): RecordDescription {
  try {
    const format = dataFormatOfField(readRecordHead(record).valueField);
    return { format, timestampMs: readRecordTimestamp(record) };
  } catch {
    return { format: undefined, timestampMs: undefined };
  }
}
