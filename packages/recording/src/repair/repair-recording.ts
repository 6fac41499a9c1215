import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordingHeader } from '../records/recording-header.ts';
import type { RecordingFile } from '../storage/recording-storage.ts';

/** What was saved of a damaged file. */
export interface Repair {
  /** From the first record to the last that is whole, nanoseconds. */
  readonly durationNs: bigint;
  readonly records: number;
  /** Time of the last record that is whole: later ones may be missing. Undefined without records. */
  readonly lostAfterNs: bigint | undefined;
  /** Bytes at the end that were cut off. */
  readonly cutBytes: number;
}

/**
 * Gives a file without its end indexes and footer in place; what is behind the last whole chunk is cut off.
 *
 * @returns undefined when the file is whole
 * @throws RecordingError when the file is no MCAP file
 */
export declare function repairRecording(file: RecordingFile): Promise<Repair | undefined>;

/** Changes of a recording that is complete. */
export interface RecordingChange {
  readonly events?: readonly RecordingEvent[];
  /** Replaces the header. */
  readonly header?: RecordingHeader;
}

/** Appends to a recording that is complete. A file that is cut off meanwhile can be repaired. @throws RecordingError when it is not whole */
export declare function changeRecording(
  file: RecordingFile,
  change: RecordingChange,
): Promise<void>;
