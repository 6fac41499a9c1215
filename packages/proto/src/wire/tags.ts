/** Tags (field number and wire type) of the members of `TopicData` and `TopicDataRecordList`. */

/** `TopicData.topic_data_record` */
export const RECORD_TAG = 18;
/** `TopicData.topic_data_record_list` */
export const LIST_TAG = 26;
/** `TopicData.error` */
export const ERROR_TAG = 34;
/** `TopicDataRecordList.elements` */
export const LIST_ELEMENT_TAG = 10;
