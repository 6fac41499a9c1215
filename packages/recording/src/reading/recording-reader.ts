import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordedSession, RecordingEvent } from '../records/recording-event.ts';
import type { RecordingSummary } from '../records/recording-summary.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';

/** Which records, and in which order. */
export interface RecordsQuery {
  /** @default all */
  readonly topics?: readonly string[];
  /** First time, inclusive. @default the start */
  readonly fromNs?: bigint;
  /** Last time, inclusive. @default the end */
  readonly untilNs?: bigint;
  /** From the last to the first. @default false */
  readonly isReverse?: boolean;
}

/** What playback reads. */
export interface RecordsReader {
  readonly summary: RecordingSummary;
  /** Records by log time. */
  records(query?: RecordsQuery): AsyncIterable<RecordedRecord>;
  /** The last record of each topic at a moment, the moment included. Reads only chunks that hold one. @param topics all by default */
  latestAt(timeNs: bigint, topics?: readonly string[]): Promise<Map<string, RecordedRecord>>;
}

/** Reads a recording by its indexes; files of other programs as well. Files without their end are opened up to the last whole chunk. */
export declare class RecordingReader implements RecordsReader {
  /** @throws RecordingError when the source is no MCAP file */
  static open(source: RecordingSource): Promise<RecordingReader>;
  readonly summary: RecordingSummary;
  records(query?: RecordsQuery): AsyncIterable<RecordedRecord>;
  latestAt(timeNs: bigint, topics?: readonly string[]): Promise<Map<string, RecordedRecord>>;
  /** The sessions as they were at a moment, by id. */
  sessionsAt(timeNs: bigint): Promise<Map<string, RecordedSession>>;
  /** All measurements of clocks, by time. */
  clocks(): Promise<RecordingEvent<'clock'>[]>;
}
