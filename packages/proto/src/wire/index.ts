export { TextCache } from '../binary/text-cache.ts';
export { DecodeError } from '../decode-error.ts';
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
export { recordValueField, scanTopicData, type TopicDataSink } from './scan-topic-data.ts';
