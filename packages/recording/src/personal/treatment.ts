import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordingHeader } from '../records/recording-header.ts';

/**
 * Replaces or drops personal data of a recording. All members are synchronous, and give the same result for the same value.
 * What is not touched is returned as it is.
 */
export interface Treatment {
  /** Returns the topic as it is shared; undefined when the whole topic is dropped. */
  topic(topic: string): string | undefined;
  /** Returns the id of a client as it is shared. The empty id of the master stays. */
  clientId(id: string): string;
  /** Returns the name of a client as it is shared. */
  clientName(name: string): string;
  /** Added to all absolute times, nanoseconds. */
  readonly shiftNs: bigint;
  /** Returns the record as it is shared, its topic included; undefined when it is dropped. */
  record(record: RecordedRecord): RecordedRecord | undefined;
  /** Returns the event as it is shared; undefined when it is dropped. */
  event(event: RecordingEvent): RecordingEvent | undefined;
  /** Says what was found of labelled values so far, as sentences without their ends. [PD-18] */
  report(): readonly string[];
  /** Returns the header as it is shared. */
  header(header: RecordingHeader): RecordingHeader;
}
