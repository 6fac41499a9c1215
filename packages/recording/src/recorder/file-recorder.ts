import type { FlightRecords, Recording, RecordingMarker } from '@ubii/proto';
import type { NamedChannel } from '../arena/channels.ts';
import type { RecordSpans, SharedRecords } from '../arena/shared-records.ts';
import type { FoundSpans } from './find-records.ts';
import type { FlightSnapshot } from './flight-recorder.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { MarkerJob, Recorder, RecorderState, RecordingJob } from './recorder.ts';

/** What is recorded into files now. */
export type FileState = Omit<RecorderState, 'flight'>;

/** Writes files of records that it reads in memory of a `SharedRecorder`, maybe on another thread. Calls are carried out in the order in which they come. */
export interface FileRecorder extends Pick<
  Recorder,
  'start' | 'stop' | 'list' | 'get' | 'makerOf' | 'change' | 'delete' | 'adopt' | 'close'
> {
  /** Grows when all is forgotten that was opened and read before. */
  readonly generation: number;
  /** Records are in this memory from now on. */
  open(memory: SharedRecords): void;
  /** Overwrites memory that is not used any more. */
  erase(memory: SharedRecords): void;
  /** Has running recordings take the records. @param channels that were taken since the last call @returns when they were read */
  read(spans: RecordSpans, channels: readonly NamedChannel[]): Promise<void>;
  /** Records an event in these targets. Never throws. */
  addEvent(event: RecordingEvent, targets: number): void;
  /** Marks what runs. @param isFlightOn the flight recorder is marked as well */
  mark(job: MarkerJob, isFlightOn: boolean): Promise<RecordingMarker>;
  /** Reads records of the flight recorder. */
  find(search: FoundSpans): Promise<FlightRecords>;
  /** Writes what the flight recorder held. */
  keep(job: RecordingJob, snapshot: FlightSnapshot): Promise<Recording>;
  /** Calls `listener` when a recording starts or ends, and each second while one runs. For one listener. */
  onState(listener: (state: FileState) => void): void;
}
