export { TextCache } from '../binary/text-cache.ts';
export { DecodeError } from '../decode-error.ts';
export { changeRecordHead, type RecordHeadChange } from './change-record-head.ts';
export {
  encodeErrorFrame,
  encodeNodeMessageFrame,
  encodeRecordListFrame,
  listHeaderSize,
  recordFrameHeader,
  recordHeaderSize,
  recordListSize,
  writeElementHeader,
  writeListHeader,
  writeRecordHeader,
} from './frames.ts';
export {
  PING_TEXT,
  PONG_TEXT,
  formatPong,
  isBinaryPong,
  readHeartbeat,
  type Heartbeat,
  type TimedPing,
  type TimedPong,
  type ToldClock,
} from './heartbeat.ts';
export {
  encodeLockstepReplyFrame,
  encodeLockstepRequestFrame,
  readNodeMessage,
  type EncodedNodeMessage,
  type LockstepMessage,
} from './node-messages.ts';
export {
  encodeRecordPart,
  prepareRecordsForMasters,
  readRecordPart,
  type RecordPart,
  type RecordsForMasters,
} from './record-parts.ts';
export { readRecordHead, type RecordHead } from './record-head.ts';
export { readRecordTimestamp } from './record-timestamp.ts';
export { MAX_NESTED_MESSAGES } from '../binary/max-nested-messages.ts';
export {
  TopicDataScan,
  recordValueField,
  scanTopicData,
  type ScanOptions,
  type TopicDataSink,
} from './scan-topic-data.ts';
export { scanServiceRequest, type RequestScan } from './scan-service-request.ts';
