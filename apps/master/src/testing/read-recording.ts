import { decodeRecord } from '@ubii/proto';
import { RecordingReader, type RecordingSource, type RecordingSummary } from '@ubii/recording';

/** A recording as tests compare it. */
export interface ReadRecording {
  readonly summary: RecordingSummary;
  /** Topics and values, in the order of the file. */
  readonly values: readonly (readonly [topic: string, value: unknown])[];
}

/** Reads all of a recording. */
export async function readRecording(source: RecordingSource): Promise<ReadRecording> {
  const reader = await RecordingReader.open(source);
  const values: [string, unknown][] = [];
  for await (const { topic, record } of reader.records()) {
    values.push([topic, decodeRecord(record).value]);
  }
  return { summary: reader.summary, values };
}
