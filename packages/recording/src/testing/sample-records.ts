import { DATA_FORMATS, encodeRecord, type DataFormat, type RecordInit } from '@ubii/proto';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingHeader } from '../records/recording-header.ts';

/** Time at which samples begin: nanoseconds since the Unix epoch. */
export const SAMPLE_START_NS = 1_750_000_000_000_000_000n;

/** A header for tests. */
export const SAMPLE_HEADER: RecordingHeader = {
  name: 'Tuesday',
  kind: 'recording',
  masterName: 'lab',
  version: '0.1.0',
  notes: '',
  selection: '{}',
};

/** A record of a topic that holds a number. @param atMs after the start of the samples */
export function sampleRecord(topic: string, atMs: number, value = atMs): RecordedRecord {
  const logTimeNs = SAMPLE_START_NS + BigInt(Math.round(atMs * 1e6));
  const record = encodeRecord({ topic, format: 'double', value });
  return { topic, clientId: 'ada', record, logTimeNs, publishTimeNs: logTimeNs };
}

/** An encoded record of each data format, its value as simple as the format allows. */
export function recordOfEachFormat(): Map<DataFormat, Uint8Array> {
  const formats = Object.keys(DATA_FORMATS) as DataFormat[];
  return new Map(
    formats.map((format) => [
      format,
      encodeRecord({
        topic: `/format/${format}`,
        format,
        value: simpleValue(format),
      } as RecordInit),
    ]),
  );
}

function simpleValue(format: DataFormat): unknown {
  switch (format) {
    case 'bool':
      return true;
    case 'string':
      return 'ä';
    case 'double':
    case 'float':
    case 'int32':
      return -1.5;
    case 'image2D':
      return { width: 2, height: 1, data: Uint8Array.of(0, 255) };
    default:
      return {};
  }
}
