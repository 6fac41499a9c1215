import { decodeRecord, type TopicRecord } from '@ubii/proto';

/** A record with a value; undefined for one without, for a broken one and for messages of other programs. */
export function decodeRecorded(topic: string, bytes: Uint8Array): TopicRecord | undefined {
  try {
    const record = decodeRecord(bytes);
    return record.format === undefined ? undefined : { ...record, topic };
  } catch {
    return undefined;
  }
}
