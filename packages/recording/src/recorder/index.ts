export {
  FLIGHT_TARGET,
  type FlightJob,
  type KeptRecording,
  type MarkerJob,
  type Recorder,
  type RecordingBatch,
  type RecorderList,
  type RecorderState,
  type RecordingJob,
  type RecordingTexts,
  type RecordSource,
  type RecordToKeep,
  type RunningJob,
} from './recorder.ts';
export { clientEvent, clockEvent, deviceEvent, eventOf, gapEvent, sessionEvent } from './facts.ts';
export { msOf, nsOf } from './nanoseconds.ts';
export { RecorderEngine, type RecorderContext, type RecorderLimits } from './recorder-engine.ts';
export type { OpenFile, RecordingFolder } from './recording-folder.ts';
export { AT_MASTER } from './file-facts.ts';
export { isInternalTopic } from './internal-topics.ts';
export { OpenBatch, recordsOf, type BatchedSource } from './recording-batch.ts';
