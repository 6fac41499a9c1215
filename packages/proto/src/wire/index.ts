export { DecodeError } from '../decode-error.ts';
export { encodeErrorFrame, encodeRecordListFrame, recordFrameHeader } from './frames.ts';
export { recordValueField, scanTopicData, type TopicDataSink } from './scan-topic-data.ts';
