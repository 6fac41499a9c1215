import type { ServiceErrorCode } from '@ubii/proto';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecorderLimits } from '../recorder/recorder-limits.ts';
import type { CheckLimits } from './check-messages.ts';
import type {
  Recorder,
  RecorderState,
  RecordingBatch,
  RecordSource,
} from '../recorder/recorder.ts';

/** What the thread starts with. */
export interface RecorderThreadData {
  /** Path of the folder of the recordings. */
  readonly folder: string;
  readonly limits: RecorderLimits & CheckLimits;
  /** URL of the built process that checks files. */
  readonly checkProcessFile: string;
}

/** What is called of the recorder, and answered. */
export type RecorderCalls = Omit<Recorder, 'waitingBytes' | 'add' | 'addEvent' | 'onState'>;
export type RecorderMethod = keyof RecorderCalls;

/** To the thread. */
export type ToThread =
  | {
      readonly kind: 'batch';
      readonly batch: Omit<RecordingBatch, 'sources'>;
      /** Its sources, by their numbers among all. */
      readonly numbers: readonly number[];
      /** Those that are new, in the order of their numbers. */
      readonly added: readonly RecordSource[];
      /** True: earlier sources are forgotten, and numbers begin again. */
      readonly isFresh: boolean;
    }
  | { readonly kind: 'ended'; readonly topics: readonly string[] }
  | { readonly kind: 'event'; readonly event: RecordingEvent; readonly targets: number }
  | {
      readonly kind: 'call';
      readonly id: number;
      readonly method: RecorderMethod;
      readonly args: readonly unknown[];
    };

/** From the thread. */
export type FromThread =
  | { readonly kind: 'taken'; readonly bytes: number }
  | { readonly kind: 'state'; readonly state: RecorderState }
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
