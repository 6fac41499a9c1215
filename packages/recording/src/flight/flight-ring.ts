import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordingWriter } from '../writing/recording-writer.ts';

/** What a flight ring may hold. */
export interface FlightRingLimits {
  readonly maxMs: number;
  readonly maxBytes: number;
  /** Keep `image2D` and `image2DList`. */
  readonly withImages: boolean;
}

/** What a flight ring holds. */
export interface FlightRingContent {
  /** From the oldest record to the newest, milliseconds. */
  readonly heldMs: number;
  /** Memory taken, bytes. */
  readonly heldBytes: number;
  readonly records: number;
  readonly topics: number;
}

/**
 * The last minutes in memory. The oldest records leave first. Large records (over 16 KiB) and small ones have half of
 * the memory each, and more only while the other half is not needed: pictures cannot push out everything else.
 */
export declare class FlightRing {
  constructor(limits: FlightRingLimits);
  get content(): FlightRingContent;
  /** Keeps a copy of a record. */
  addRecord(record: RecordedRecord): void;
  addEvent(event: RecordingEvent): void;
  /** Changes limits; what exceeds them leaves at once. */
  setLimits(limits: FlightRingLimits): void;
  /** Forgets a topic that has no value any more, unless it has records in the window. */
  forget(topic: string): void;
  clear(): void;
  /** Writes what is held; values that are older and still stand are written at the beginning. */
  writeTo(writer: RecordingWriter): Promise<void>;
}
