export { FLIGHT_TARGET } from '../arena/flight-target.ts';
export {
  type FlightJob,
  type KeptRecording,
  type MarkerJob,
  type Recorder,
  type RecorderList,
  type RecorderState,
  type RecordingJob,
  type RecordingPage,
  type RecordingTexts,
  type RunningJob,
} from './recorder.ts';
export { clientEvent, clockEvent, deviceEvent, eventOf, gapEvent, sessionEvent } from './facts.ts';
export { MAX_TIME_MS } from '../records/event-schemas.ts';
export { msOf, nsOf } from './nanoseconds.ts';
export type { RecordSearch } from './find-records.ts';
export type { RecorderContext } from './recorder-engine.ts';
export { recordHere } from './local-recorder.ts';
export type { RecorderLimits } from './recorder-limits.ts';
export { LocalChecker } from './check-file.ts';
export type { CheckJob, FileChecker, Verdict } from './file-checker.ts';
export {
  formatRejection,
  parseRejection,
  type RejectedFile,
  type Rejection,
} from './rejected-file.ts';
export type { OpenFile, RecordingFolder } from './recording-folder.ts';
export { AT_MASTER, WITHOUT_PAGE } from './file-facts.ts';
export { elementsFrom } from './recording-page.ts';
export { isInternalTopic } from './internal-topics.ts';
export type { ChannelSource } from '../arena/channels.ts';
