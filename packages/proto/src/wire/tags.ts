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
