/** Name of the MCAP schema of our records. */
export const RECORD_SCHEMA_NAME = 'ubii.topicData.TopicDataRecord';
