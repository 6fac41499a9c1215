import { dataFormatOfField, type DataFormat } from '@ubii/proto';
import { readRecordHead, readRecordTimestamp } from '@ubii/proto/wire';

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

/** Milliseconds of nanoseconds, with fractions. */
export function msOf(ns: bigint): number {
  return Number(ns / 1000n) / 1000;
}

/** Nanoseconds of milliseconds, to the microsecond. */
export function nsOf(ms: number): bigint {
  return BigInt(Math.round(ms * 1000)) * 1000n;
}

/** A record as it stands in files, with the time of its publisher. */
export function recordedOf(
  { topic, clientId }: Pick<RecordedRecord, 'topic' | 'clientId'>,
  record: Uint8Array,
  timeMs: number,
): RecordedRecord {
  const logTimeNs = nsOf(timeMs);
  const { timestampMs } = describeRecord(record);
  const publishTimeNs = timestampMs === undefined ? logTimeNs : nsOf(timestampMs);
  return { topic, clientId, record, logTimeNs, publishTimeNs };
}
