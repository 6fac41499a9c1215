export { FOREIGN_PICTURE_BYTES, foreignRecording } from './foreign-recording.ts';
export { MemoryFile } from './memory-file.ts';
export { plainRecording } from './plain-recording.ts';
export { readRecords } from './read-records.ts';
export { recorded } from './recorded.ts';
export {
  recordOfEachFormat,
  SAMPLE_HEADER,
  SAMPLE_START_NS,
  sampleRecord,
} from './sample-records.ts';
export { recordedDevice } from './recorded-device.ts';
export {
  attachmentIndexOf3Gib,
  lz4Bomb,
  manyMarkers,
  manyMarkersWithoutEnd,
  markerChunkIndexOf3Gib,
  metadataIndexOf3Gib,
  recordChunkIndexOf3Gib,
} from './hostile-files.ts';
