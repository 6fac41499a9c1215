import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordingHeader } from '../records/recording-header.ts';
import type { RecordingSink } from '../storage/recording-storage.ts';

/** Numbers of a recording that is being written. */
export interface WriterStatistics {
  readonly records: number;
  readonly topics: number;
  readonly markers: number;
  /** Records that were refused because a file has no more than 65 535 channels. */
  readonly refusedRecords: number;
  /** Bytes of the file so far, without what `flush` would write. */
  readonly bytes: number;
}

/**
 * Writes a recording. A chunk ends with 1 MiB or with the first record that is 1 s later than its first; call `flush`
 * once a second as well, so that silence does not keep the last records in memory.
 */
export declare class RecordingWriter {
  static create(sink: RecordingSink, header: RecordingHeader): Promise<RecordingWriter>;
  get statistics(): WriterStatistics;
  /**
   * Adds a record; its bytes are copied.
   *
   * @returns a promise when a chunk was closed: await it to wait for the sink. Not waiting is allowed.
   * @throws the error of the sink, once it has failed
   */
  addRecord(record: RecordedRecord): Promise<void> | undefined;
  /** Adds an event. @throws the error of the sink, once it has failed */
  addEvent(event: RecordingEvent): void;
  /** Closes the chunk and waits until everything is with the sink. @throws the error of the sink */
  flush(): Promise<void>;
  /** Writes the rest, indexes and footer. The sink stays open. @throws the error of the sink */
  end(): Promise<void>;
}
