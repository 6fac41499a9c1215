import type {
  FlightRecorder,
  FlightRecorderSettings,
  FlightRecords,
  Recording,
  RecordingBudget,
  RecordingMarker,
  RecordingSelection,
  RecordingStudy,
} from '@ubii/proto';

import type { ChannelSource } from '../arena/channels.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordSearch } from './find-records.ts';

/** A recording to start, or to keep of the flight recorder. */
export interface RecordingJob {
  readonly id: string;
  readonly name: string;
  readonly notes: string;
  readonly author: string;
  /** Whose it is, as the master writes makers; empty for its operator [RC-66]. */
  readonly makerId: string;
  readonly masterName: string;
  readonly version: string;
  /** Id of the recording that is replayed meanwhile; then it is a comparison [RP-41]. Default: none. */
  readonly replayedRecordingId?: string;
  /** Labels of personal data as JSON; empty when there are none. [PD-6] */
  readonly personalData: string;
  /** Which part of a study it is [ST-24]. */
  readonly study?: RecordingStudy | undefined;
  /** Of an upload: a node recorded it for this master, so that most of what its file says of it stays. [RC-63] */
  readonly isOfNode?: boolean;
  /** Of an upload: it stays part of the study in its header. [RC-41] @default false */
  readonly keepsStudy?: boolean;
}

/** A recording to start. */
export interface RunningJob extends RecordingJob {
  /** Its bit in the targets of records, from 2 to 2^15. */
  readonly target: number;
  readonly selection: RecordingSelection;
  /** All members are set. */
  readonly budget: RecordingBudget;
  /** Clients and sessions as they are. */
  readonly present: readonly RecordingEvent[];
}

/** Limits of the flight recorder; `present` are clients and sessions as they are. */
export interface FlightJob extends FlightRecorderSettings {
  readonly present: readonly RecordingEvent[];
}

/** A finished or running recording, with its maker. */
export interface KeptRecording {
  readonly recording: Recording;
  readonly makerId: string;
}

/** All recordings. */
export interface RecorderList {
  /** The newest first. */
  readonly recordings: readonly Recording[];
  /** Makers, by id of the recording. [RC-66] */
  readonly makers: ReadonlyMap<string, string>;
  readonly sizeBytes: number;
  /** Free space on the disk, bytes; 0 when unknown. */
  readonly freeBytes: number;
}

/** What is recorded now. */
export interface RecorderState {
  /** The newest first. */
  readonly running: readonly Recording[];
  /** Targets of those that run. */
  readonly targets: number;
  readonly flight: FlightRecorder;
  /** Grows with each recording that is added, changed, finished or deleted. */
  readonly listRevision: number;
}

/** A change of name and notes. */
export interface RecordingTexts {
  readonly name: string;
  readonly notes: string;
}

/** A marker to add, change or remove. */
export interface MarkerJob {
  /** `recordingId` empty: all that run and the flight recorder. `id` and `timeMs` are set. */
  readonly marker: RecordingMarker;
  /** How it came, for one that is new. @default service */
  readonly kind?: 'service' | 'topic';
  /** Finished recordings, and markers of others, as well: the maker of the recording, and admins [RC-21]. */
  readonly mayChangeAll: boolean;
}

/** Where a page of a recording begins: places among all topics and markers, from 0. */
export interface RecordingPage {
  readonly topicsFrom: number;
  readonly markersFrom: number;
}

/**
 * Writes recordings and keeps the last minutes. Calls are carried out in the order in which they come. Promises are rejected with
 * a `ServiceError`.
 */
export interface Recorder {
  /**
   * Copies a record. Never throws, and never waits.
   *
   * @param record encoded `ubii.topicData.TopicDataRecord`
   * @param timeMs when it came, epoch milliseconds
   * @param targets bits of what records it: `FLIGHT_TARGET`, and the targets of recordings
   */
  add(source: ChannelSource, record: Uint8Array, timeMs: number, targets: number): void;
  /** Records in the flight recorder that a topic has no value any more, after the records before. Never throws. */
  endTopic(topic: string): void;
  /** Records an event in these targets. Never throws. */
  addEvent(event: RecordingEvent, targets: number): void;
  /** Has files take what came so far. */
  flush(): void;
  /** Resolves when the file is open. */
  start(job: RunningJob): Promise<Recording>;
  /** Closes the file. A recording that is finished stays as it is. */
  stop(id: string): Promise<Recording>;
  list(): Promise<RecorderList>;
  /** @param page of topics and markers; default: neither */
  get(id: string, page?: RecordingPage): Promise<KeptRecording>;
  /** Whose a recording is, without reading its file. [RC-66] */
  makerOf(id: string): Promise<string>;
  change(id: string, texts: RecordingTexts): Promise<Recording>;
  /** Deletes the file; stops a running recording first. */
  delete(id: string): Promise<void>;
  mark(job: MarkerJob): Promise<RecordingMarker>;
  setFlight(job: FlightJob): Promise<FlightRecorder>;
  flight(): Promise<FlightRecorder>;
  /** Reads what the flight recorder holds of some topics, without the values that stood before. */
  find(search: RecordSearch): Promise<FlightRecords>;
  /** Writes what the flight recorder holds. */
  keep(job: RecordingJob): Promise<Recording>;
  /** Takes a file that was uploaded as `id` into the list. Deletes it when it is no recording. */
  adopt(job: RecordingJob): Promise<Recording>;
  /** Calls `listener` when a recording starts or ends, and each second while something is recorded. For one listener. */
  onState(listener: (state: RecorderState) => void): void;
  /** Closes all files. */
  close(): Promise<void>;
}

/** Topics, below the id of a page, on which it publishes its state and the results of its preflight. [EX-49] [EX-56] [AC-30] */
const OF_PAGES = ['page_state', 'graph_editor/presence', 'preflight'];

/** Whether a page publishes its own state there: recorded only where a selection names it. [RC-12] */
export function isInternalTopic(topic: string, publisherId: string): boolean {
  return OF_PAGES.some((rest) => topic === `/${publisherId}/${rest}`);
}
