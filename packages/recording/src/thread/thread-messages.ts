import type { ServiceErrorCode } from '@ubii/proto';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecorderLimits } from '../recorder/recorder-limits.ts';
import type { CheckLimits } from './check-messages.ts';
import type { SharedRecords } from '../arena/shared-records.ts';
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

/** What is called of the recorder, and answered. */
export type RecorderCalls = Omit<
  FileRecorder,
  'generation' | 'open' | 'erase' | 'addEvent' | 'onState'
>;
export type RecorderMethod = keyof RecorderCalls;

/** Lists of what the flight recorder held, some elements at a time. */
export type SnapshotPart = Pick<FlightSnapshot, 'channels' | 'standing' | 'events'>;

/** To the thread. */
export type ToThread =
  | { readonly kind: 'open'; readonly memory: SharedRecords }
  | { readonly kind: 'erase'; readonly memory: SharedRecords }
  /** Of the snapshot that is kept next. */
  | { readonly kind: 'part'; readonly part: SnapshotPart }
  | { readonly kind: 'event'; readonly event: RecordingEvent; readonly targets: number }
  | {
      readonly kind: 'call';
      readonly id: number;
      readonly method: RecorderMethod;
      readonly args: readonly unknown[];
    };

/** From the thread. */
export type FromThread =
  | { readonly kind: 'state'; readonly state: FileState }
  | { readonly kind: 'reply'; readonly id: number; readonly value: unknown }
  | {
      readonly kind: 'refusal';
      readonly id: number;
      readonly code: ServiceErrorCode;
      readonly message: string;
      readonly details: Readonly<Record<string, unknown>>;
      /** What caused it, for the log; empty when there is nothing to say. */
      readonly cause: string;
    };
