import type { RecorderLimits } from '../recorder/recorder-limits.ts';
import type { CheckLimits } from './check-messages.ts';
import type { FlightSnapshot } from '../recorder/flight-recorder.ts';
import type { FileRecorder, FileState } from '../recorder/file-recorder.ts';

/** What the thread starts with. */
export interface RecorderThreadData {
  /** Path of the folder of the recordings. */
  readonly folder: string;
  readonly limits: RecorderLimits & CheckLimits;
  /** URL of the built process that checks files. */
  readonly checkProcessFile: string;
}

/** Lists of what the flight recorder held, some elements at a time. */
export type SnapshotPart = Pick<FlightSnapshot, 'channels' | 'standing' | 'events'>;

/** What is called of the thread. */
export interface RecorderThread extends Omit<FileRecorder, 'generation' | 'onState'> {
  /** Adds to the snapshot that is kept next. */
  addPart(part: SnapshotPart): void;
}

/** What the thread calls. */
export interface RecorderOwner {
  showState(state: FileState): void;
}
