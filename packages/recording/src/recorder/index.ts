export { FLIGHT_TARGET } from '../arena/shared-records.ts';
export {
  isInternalTopic,
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
export { msOf, nsOf } from '../records/recorded-record.ts';
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
  type OpenFile,
  type RecordingFolder,
} from './recording-folder.ts';
export { AT_MASTER, WITHOUT_PAGE } from './file-facts.ts';
export { elementsFrom } from './recording-page.ts';
export type { ChannelSource } from '../arena/channels.ts';
