/** Tags (field number and wire type) that are written and read without the generated code. */

/** `TopicData.topic_data_record` */
export const RECORD_TAG = 18;
/** `TopicData.topic_data_record_list` */
export const LIST_TAG = 26;
/** `TopicData.error` */
export const ERROR_TAG = 34;
/** `TopicData.node_message` */
export const NODE_MESSAGE_TAG = 8002;
/** `TopicDataRecordList.elements` */
export const LIST_ELEMENT_TAG = 10;
/** `TopicDataRecord.topic` */
export const TOPIC_TAG = 10;
/** `TopicDataRecord.timestamp` */
export const TIMESTAMP_TAG = 18;
/** `TopicDataRecord.client_id` */
export const CLIENT_ID_TAG = 266;
/** `TopicDataRecord.extension` */
export const RECORD_EXTENSION_TAG = 8026;
/** `RecordExtension.keep_seconds` */
export const KEEP_SECONDS_TAG = 8;
/** `RecordExtension.expiry_ms` */
export const EXPIRY_MS_TAG = 16;
/** `NodeMessage.lockstep_request` */
export const LOCKSTEP_REQUEST_TAG = 10;
/** `NodeMessage.lockstep_reply` */
export const LOCKSTEP_REPLY_TAG = 18;
/** `NodeMessage.module_reports` */
export const MODULE_REPORTS_TAG = 26;
/** `NodeMessage.ended_topics` */
export const ENDED_TOPICS_TAG = 34;
/** `NodeMessage.recorder_order` */
export const RECORDER_ORDER_TAG = 42;
/** `NodeMessage.recorder_answer` */
export const RECORDER_ANSWER_TAG = 50;
/** `NodeMessage.recorder_report` */
export const RECORDER_REPORT_TAG = 58;
/** `NodeMessage.bridge_order` */
export const BRIDGE_ORDER_TAG = 66;
/** `NodeMessage.bridge_answer` */
export const BRIDGE_ANSWER_TAG = 74;
/** `LockstepProcessingRequest.records` and `LockstepProcessingReply.records` */
export const LOCKSTEP_RECORD_TAG = 18;
/** `ClusterMessage.part` */
export const PART_TAG = 34;
/** `ClusterPart.stream` */
export const PART_STREAM_TAG = 8;
/** `ClusterPart.number` */
export const PART_NUMBER_TAG = 16;
/** `ClusterPart.records` */
export const PART_RECORDS_TAG = 66;
/** `ClusterRecords.records` */
export const TOLD_RECORD_TAG = 10;
/** `ClusterRecords.stamps` */
export const TOLD_STAMPS_TAG = 18;
/** `ClusterRecords.publishers` */
export const TOLD_PUBLISHERS_TAG = 26;
/** `ClusterRecords.publisher_ids` */
export const TOLD_PUBLISHER_ID_TAG = 34;
