export {
  describeRecord,
  type RecordedRecord,
  type RecordDescription,
} from './records/recorded-record.ts';
export {
  EVENT_TOPICS,
  type ClientClock,
  type EventKind,
  type EventValue,
  type Gap,
  type Marker,
  type RecordedClient,
  type RecordedComponent,
  type RecordedDevice,
  type RecordedSession,
  type RecordingEvent,
} from './records/recording-event.ts';
export type {
  AttachedFile,
  ForeignParts,
  RecordedTopic,
  RecordingSummary,
} from './records/recording-summary.ts';
export type { RecordingHeader, RecordingKind } from './records/recording-header.ts';
export { RecordingError } from './records/recording-error.ts';
export type { RecordingFile, RecordingSink, RecordingSource } from './storage/recording-storage.ts';
export { RecordingWriter, type WriterStatistics } from './writing/recording-writer.ts';
export {
  RecordingReader,
  type EventsReader,
  type RecordingActivity,
  type RecordsQuery,
  type RecordsReader,
} from './reading/recording-reader.ts';
export type { MalformedEvents } from './reading/recorded-events.ts';
export {
  devicesInSpan,
  isRecordedDevice,
  devicesByTopic,
  topicsOfProfile,
} from './reading/recorded-devices.ts';
export {
  OutlineReader,
  type RecordingOutline,
  type TopicOutline,
} from './reading/outline-reader.ts';
export {
  changeRecording,
  repairRecording,
  type RecordingChange,
  type Repair,
} from './repair/repair-recording.ts';
export {
  Playback,
  type PlaybackOptions,
  type PlaybackSink,
  type PlaybackState,
  type Span,
} from './playback/playback.ts';
export { cutRecording, type CutOptions, type CutSource } from './cut/cut-recording.ts';
