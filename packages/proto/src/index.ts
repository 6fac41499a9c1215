export * from './generated/messages.ts';
export { decode, encode, isMessageType, type MessageType } from './codec.ts';
export { DecodeError } from './decode-error.ts';
export type { Init } from './init.ts';
export { unpackFlightRecords, type FlightRecord } from './flight-records.ts';
export {
  FIRST_EXTENSION_FIELD,
  messageDescriptor,
  type EnumDescriptor,
  type FieldDescriptor,
  type MessageDescriptor,
  type ScalarType,
} from './descriptor.ts';
export { findJsonProblems, fromJson, type JsonProblem } from './json/from-json.ts';
export { JsonScan, type JsonScanExcess, type JsonScanLimits } from './json/json-scan.ts';
export { toJson, type JsonObject, type JsonValue } from './json/to-json.ts';
export type { DataFormat, DataFormatValues } from './data-formats/data-format-values.ts';
export {
  DATA_FORMATS,
  dataFormatOfField,
  isDataFormat,
  type DataFormatFamily,
  type DataFormatInfo,
} from './data-formats/data-formats.ts';
export { parseDataFormat } from './data-formats/parse-data-format.ts';
export { isCompressedImage } from './data-formats/validate-value.ts';
export {
  decodeRecord,
  decodeTopicData,
  encodeRecord,
  isRecordMember,
  recordOf,
  type DecodedTopicData,
  type EmptyRecord,
  type RecordInit,
  type TopicRecord,
} from './records.ts';
export { matchesProfile, selectByProfiles, type Profiled } from './profiles.ts';
export { isSameValue } from './same-value.ts';
export { DEFAULT_TEXT_LIMITS, type TextLimits } from './text-limits.ts';
export { timestampFromMs, timestampToMs } from './timestamp.ts';
export {
  SERVICES,
  serviceByTopic,
  type ServiceName,
  type ServiceReplyOf,
  type ServiceRequestOf,
} from './services/services.ts';
export { masterHost, masterProofText, type MasterProofFacts } from './services/master-proof.ts';
export type { ReplyMember, RequestMember, ServiceInfo } from './services/define-service.ts';
export {
  isServiceErrorCode,
  SERVICE_ERROR_CODES,
  ServiceError,
  type ServiceErrorCode,
  type ServiceErrorOptions,
} from './service-error.ts';
export {
  clientTopic,
  componentTopic,
  EXTENSION_SERVICE_PREFIX,
  globToRegExpSource,
  FAREWELL_TOPIC,
  identifyTopic,
  INFO_TOPICS,
  isExtensionTopic,
  isMasterTopic,
  preflightTopic,
  moduleEventTopic,
  MASTERS_TOPIC,
  RECORDING_STATUS_TOPIC,
  REPLAYS_TOPIC,
  STUDY_STATUS_TOPIC,
  sessionStatisticsTopic,
  UUID_PATTERN,
  isUuid,
} from './topics.ts';
export { LEGACY_CONSTANTS } from './legacy-constants.ts';
