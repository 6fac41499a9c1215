// Made from schema/*.proto by scripts/generate.ts. Change the schema, then run `pnpm generate`.

/** `ubii.clients.Client.State` */
export const ClientState = {
  ACTIVE: 0,
  INACTIVE: 1,
  UNAVAILABLE: 2,
} as const;
export type ClientState = (typeof ClientState)[keyof typeof ClientState];

/** `ubii.dataStructure.ButtonEventType` */
export const ButtonEventType = {
  UP: 0,
  DOWN: 1,
} as const;
export type ButtonEventType = (typeof ButtonEventType)[keyof typeof ButtonEventType];

/** `ubii.dataStructure.HandGestureType` */
export const HandGestureType = {
  REST: 0,
  FINGERS_SPREAD: 1,
  WAVE_IN: 2,
  WAVE_OUT: 3,
  FIST: 4,
  DOUBLE_TAP: 5,
} as const;
export type HandGestureType = (typeof HandGestureType)[keyof typeof HandGestureType];

/** `ubii.dataStructure.Image2D.DataFormat` */
export const Image2DDataFormat = {
  GRAY8: 0,
  RGB8: 1,
  RGBA8: 2,
} as const;
export type Image2DDataFormat = (typeof Image2DDataFormat)[keyof typeof Image2DDataFormat];

/** `ubii.dataStructure.TouchEvent.TouchEventType` */
export const TouchEventType = {
  TOUCH_START: 0,
  TOUCH_MOVE: 1,
  TOUCH_END: 2,
} as const;
export type TouchEventType = (typeof TouchEventType)[keyof typeof TouchEventType];

/** `ubii.devices.Component.IOType` */
export const ComponentIOType = {
  PUBLISHER: 0,
  SUBSCRIBER: 1,
} as const;
export type ComponentIOType = (typeof ComponentIOType)[keyof typeof ComponentIOType];

/** `ubii.devices.Device.DeviceType` */
export const DeviceType = {
  PARTICIPANT: 0,
  WATCHER: 1,
} as const;
export type DeviceType = (typeof DeviceType)[keyof typeof DeviceType];

/** `ubii.extension.MasterAddress.Kind` */
export const MasterAddressKind = {
  LOOPBACK: 0,
  WIFI: 1,
  ETHERNET: 2,
  VIRTUAL: 3,
} as const;
export type MasterAddressKind = (typeof MasterAddressKind)[keyof typeof MasterAddressKind];

/** `ubii.extension.StatusEvent.Kind` */
export const StatusEventKind = {
  CLIENT_JOINED: 0,
  CLIENT_LEFT: 1,
  CLIENT_LOST: 2,
  CLIENT_RETURNED: 3,
  LIMIT_REACHED: 4,
  MASTER_STARTED: 5,
} as const;
export type StatusEventKind = (typeof StatusEventKind)[keyof typeof StatusEventKind];

/** `ubii.extension.StatusProblem.Severity` */
export const StatusProblemSeverity = {
  WARNING: 0,
  ERROR: 1,
} as const;
export type StatusProblemSeverity = (typeof StatusProblemSeverity)[keyof typeof StatusProblemSeverity];

/** `ubii.processing.ProcessingModule.Language` */
export const ProcessingModuleLanguage = {
  CPP: 0,
  PY: 1,
  JS: 2,
  CS: 3,
  JAVA: 4,
} as const;
export type ProcessingModuleLanguage = (typeof ProcessingModuleLanguage)[keyof typeof ProcessingModuleLanguage];

/** `ubii.processing.ProcessingModule.Status` */
export const ProcessingModuleStatus = {
  INITIALIZED: 0,
  CREATED: 1,
  PROCESSING: 2,
  HALTED: 3,
  DESTROYED: 4,
} as const;
export type ProcessingModuleStatus = (typeof ProcessingModuleStatus)[keyof typeof ProcessingModuleStatus];

/** `ubii.sessions.SessionStatus` */
export const SessionStatus = {
  CREATED: 0,
  RUNNING: 1,
  PAUSED: 2,
  STOPPED: 3,
} as const;
export type SessionStatus = (typeof SessionStatus)[keyof typeof SessionStatus];

/** `ubii.clients.Client` */
export interface Client {
  id: string;
  name: string;
  devices: Device[];
  tags: string[];
  description: string;
  processingModules: ProcessingModule[];
  isDedicatedProcessingNode: boolean;
  hostIp: string;
  metadataJson: string;
  state: ClientState;
  latency: number;
  extension: ClientExtension | undefined;
}

/** `ubii.clients.ClientList` */
export interface ClientList {
  elements: Client[];
}

/** `ubii.conditions.NotifyCondition` */
export interface NotifyCondition {
  id: string;
  name: string;
  evaluationFunctionStringified: string;
  clientProfilePub: Client | undefined;
  clientProfileSub: Client | undefined;
}

/** `ubii.dataStructure.BoolList` */
export interface BoolList {
  elements: boolean[];
}

/** `ubii.dataStructure.Color` */
export interface Color {
  r: number;
  g: number;
  b: number;
  a: number;
}

/** `ubii.dataStructure.DoubleList` */
export interface DoubleList {
  elements: number[];
}

/** `ubii.dataStructure.FloatList` */
export interface FloatList {
  elements: number[];
}

/** `ubii.dataStructure.Image2D` */
export interface Image2D {
  width: number;
  height: number;
  dataFormat: Image2DDataFormat;
  data: Uint8Array;
}

/** `ubii.dataStructure.Image2DList` */
export interface Image2DList {
  elements: Image2D[];
}

/** `ubii.dataStructure.Int32List` */
export interface Int32List {
  elements: number[];
}

/** `ubii.dataStructure.KeyEvent` */
export interface KeyEvent {
  type: ButtonEventType;
  key: string;
}

/** `ubii.dataStructure.Matrix3x2` */
export interface Matrix3x2 {
  m00: number;
  m01: number;
  m10: number;
  m11: number;
  m20: number;
  m21: number;
}

/** `ubii.dataStructure.Matrix4x4` */
export interface Matrix4x4 {
  m00: number;
  m01: number;
  m02: number;
  m03: number;
  m10: number;
  m11: number;
  m12: number;
  m13: number;
  m20: number;
  m21: number;
  m22: number;
  m23: number;
  m30: number;
  m31: number;
  m32: number;
  m33: number;
}

/** `ubii.dataStructure.MouseEvent` */
export interface MouseEventMessage {
  type: ButtonEventType;
  button: number;
}

/** `ubii.dataStructure.MyoEvent` */
export interface MyoEvent {
  emg: Vector8 | undefined;
  orientation: Quaternion | undefined;
  gyroscope: Vector3 | undefined;
  accelerometer: Vector3 | undefined;
  gesture: HandGestureType;
}

/** `ubii.dataStructure.Object2D` */
export interface Object2D {
  id: string;
  pose: Pose2D | undefined;
  size: Vector2 | undefined;
  userDataJson: string;
}

/** `ubii.dataStructure.Object2DList` */
export interface Object2DList {
  elements: Object2D[];
}

/** `ubii.dataStructure.Object3D` */
export interface Object3D {
  id: string;
  pose: Pose3D | undefined;
  size: Vector3 | undefined;
  userDataJson: string;
}

/** `ubii.dataStructure.Object3DList` */
export interface Object3DList {
  elements: Object3D[];
}

/** `ubii.dataStructure.Pose2D` */
export interface Pose2D {
  position: Vector2 | undefined;
  direction?: Vector2 | undefined;
  angle?: number | undefined;
}

/** `ubii.dataStructure.Pose3D` */
export interface Pose3D {
  position: Vector3 | undefined;
  quaternion?: Quaternion | undefined;
  euler?: Vector3 | undefined;
}

/** `ubii.dataStructure.Quaternion` */
export interface Quaternion {
  x: number;
  y: number;
  z: number;
  w: number;
}

/** `ubii.dataStructure.QuaternionList` */
export interface QuaternionList {
  elements: Quaternion[];
}

/** `ubii.dataStructure.StringList` */
export interface StringList {
  elements: string[];
}

/** `ubii.dataStructure.TouchEvent` */
export interface TouchEventMessage {
  type: TouchEventType;
  position: Vector2 | undefined;
  id: string;
  force: number;
}

/** `ubii.dataStructure.TouchEventList` */
export interface TouchEventList {
  elements: TouchEventMessage[];
}

/** `ubii.dataStructure.Vector2` */
export interface Vector2 {
  x: number;
  y: number;
}

/** `ubii.dataStructure.Vector2List` */
export interface Vector2List {
  elements: Vector2[];
}

/** `ubii.dataStructure.Vector3` */
export interface Vector3 {
  x: number;
  y: number;
  z: number;
}

/** `ubii.dataStructure.Vector3List` */
export interface Vector3List {
  elements: Vector3[];
}

/** `ubii.dataStructure.Vector4` */
export interface Vector4 {
  x: number;
  y: number;
  z: number;
  w: number;
}

/** `ubii.dataStructure.Vector4List` */
export interface Vector4List {
  elements: Vector4[];
}

/** `ubii.dataStructure.Vector8` */
export interface Vector8 {
  v0: number;
  v1: number;
  v2: number;
  v3: number;
  v4: number;
  v5: number;
  v6: number;
  v7: number;
}

/** `ubii.dataStructure.Vector8List` */
export interface Vector8List {
  elements: Vector8[];
}

/** `ubii.devices.Component` */
export interface Component {
  topic: string;
  messageFormat: string;
  ioType: ComponentIOType;
  deviceId: string;
  tags: string[];
  description: string;
  id: string;
  name: string;
  notifyConditionIds: string[];
}

/** `ubii.devices.ComponentList` */
export interface ComponentList {
  elements: Component[];
}

/** `ubii.devices.Device` */
export interface Device {
  id: string;
  name: string;
  deviceType: DeviceType;
  components: Component[];
  clientId: string;
  tags: string[];
  description: string;
}

/** `ubii.devices.DeviceList` */
export interface DeviceList {
  elements: Device[];
}

/** `ubii.devices.TopicDemux` */
export interface TopicDemux {
  id: string;
  name: string;
  dataType: string;
  outputTopicFormat: string;
}

/** `ubii.devices.TopicDemuxList` */
export interface TopicDemuxList {
  elements: TopicDemux[];
}

/** `ubii.devices.TopicMux` */
export interface TopicMux {
  id: string;
  name: string;
  dataType: string;
  topicSelector: string;
  identityMatchPattern: string;
}

/** `ubii.devices.TopicMuxList` */
export interface TopicMuxList {
  elements: TopicMux[];
}

/**
 * What a client of this project and a master of this project tell each other at registration, beyond
 * what existing clients know. A client sends it to opt in; a master answers with it only to a client
 * that sent it. Rules EX-1 to EX-6.
 *
 * `ubii.extension.ClientExtension`
 */
export interface ClientExtension {
  /** Client to master: topic data may arrive as topic_data_record_list as well as single records. */
  recordLists: boolean;
  /**
   * Client to master: the token of an earlier registration, sent together with the earlier
   * Client.id, to come back as the same client; empty on a first registration.
   * Master to client: the token for this Client.id. A secret of the client, never listed.
   */
  resumeToken: string;
  /** Master to client: true when the client came back under the id it asked for. */
  resumed: boolean;
  /** Master to client: version of the master, semantic versioning. */
  masterVersion: string;
}

/** `ubii.extension.MasterAddress` */
export interface MasterAddress {
  kind: MasterAddressKind;
  /** Name of the network interface as the system calls it. */
  interfaceName: string;
  /** http or https URL with port and without a path. */
  url: string;
}

/**
 * How the master is. Counters are totals since its start.
 *
 * `ubii.extension.MasterStatus`
 */
export interface MasterStatus {
  masterId: string;
  name: string;
  version: string;
  /** Milliseconds since the Unix epoch, master's clock. */
  startedMs: number;
  /** Milliseconds since the Unix epoch, master's clock. */
  nowMs: number;
  /** Records received from clients. */
  recordsIn: number;
  /** Records handed to subscribers. */
  recordsOut: number;
  bytesIn: number;
  bytesOut: number;
  /** Records that slow subscribers did not get. */
  dropped: number;
  /** Requests, records and connections refused: malformed, forbidden or over a limit. */
  refused: number;
  /** Topics that hold a value or a subscription. */
  topics: number;
  /** Clients by state. */
  clientsActive: number;
  clientsInactive: number;
  clientsUnavailable: number;
  /** Share of one core used since the sample before, percent. */
  cpuPercent: number;
  /** Resident memory of the process, bytes. */
  memoryBytes: number;
  /** Every StatusSample after since_ms, oldest first, one every 2 s. */
  samples: StatusSample[];
  /** Every StatusEvent after since_ms, oldest first, at most 200. */
  events: StatusEvent[];
  /** What is wrong now, most severe first. */
  problems: StatusProblem[];
  /** Where the master can be reached, best first. */
  addresses: MasterAddress[];
}

/**
 * Asks how the master is. Rules EX-16 to EX-18.
 *
 * `ubii.extension.MasterStatusRequest`
 */
export interface MasterStatusRequest {
  /**
   * Samples and events after this moment are wanted: milliseconds since the Unix epoch, master's
   * clock; 0 asks for all that is kept (10 minutes).
   */
  sinceMs: number;
}

/** `ubii.extension.StatusEvent` */
export interface StatusEvent {
  timeMs: number;
  kind: StatusEventKind;
  /** A few words for people. */
  text: string;
  /** The client it is about; empty when it is about none. */
  clientId: string;
}

/** `ubii.extension.StatusProblem` */
export interface StatusProblem {
  /** Stable name of the kind of problem: client_silent, client_slow, limit_reached, protocol_errors. */
  code: string;
  severity: StatusProblemSeverity;
  /** What is wrong and what follows from it, one sentence. */
  text: string;
  clientId: string;
  /** Since when: milliseconds since the Unix epoch, master's clock. */
  sinceMs: number;
}

/** `ubii.extension.StatusSample` */
export interface StatusSample {
  /** Milliseconds since the Unix epoch, master's clock. */
  timeMs: number;
  /** Records received per second. */
  recordsPerSecond: number;
}

/**
 * Counters of one topic. All counts are totals since the topic appeared; a rate is the difference of
 * two replies over the difference of their master_time_ms.
 *
 * `ubii.extension.TopicStatistic`
 */
export interface TopicStatistic {
  topic: string;
  /** Short name of the data format of the newest record (vector2, image2D, ...); empty while the topic has no value. */
  dataFormat: string;
  /** Id of the client that published the newest record; empty for the master itself. */
  publisherId: string;
  /** Records published. */
  records: number;
  /** Encoded size of those records, bytes. */
  bytes: number;
  /** Records that a slow subscriber did not get because a newer one replaced them, summed over subscribers. */
  dropped: number;
  /** When the newest record arrived: milliseconds since the Unix epoch, master's clock; 0 when none did. */
  publishedMs: number;
  /** Clients that receive this topic now. */
  subscribers: number;
  /** Encoded size of the newest record, bytes. */
  valueBytes: number;
}

/**
 * Statistics of the topics that changed since the cursor of the request.
 *
 * `ubii.extension.TopicStatistics`
 */
export interface TopicStatistics {
  /** To be sent with the next request. */
  cursor: number;
  /** True when this is a full list: everything the client knew from earlier replies is void. */
  reset: boolean;
  elements: TopicStatistic[];
  /** Topics that were deleted since the cursor. */
  removed: string[];
  /** When this was taken: milliseconds since the Unix epoch, master's clock. */
  masterTimeMs: number;
}

/**
 * Asks for the statistics of the topics that changed since an earlier reply. Rules EX-11 to EX-15.
 *
 * `ubii.extension.TopicStatisticsRequest`
 */
export interface TopicStatisticsRequest {
  /** Cursor of the reply the client already has; 0 asks for every topic. */
  cursor: number;
}

/** `ubii.general.Error` */
export interface ErrorMessage {
  title: string;
  message: string;
  stack: string;
  code: string;
}

/** `ubii.general.ErrorList` */
export interface ErrorList {
  elements: ErrorMessage[];
}

/** `ubii.general.Success` */
export interface Success {
  title: string;
  message: string;
}

/** `ubii.general.SuccessList` */
export interface SuccessList {
  elements: Success[];
}

/** `ubii.processing.LockstepProcessingReply` */
export interface LockstepProcessingReply {
  processingModuleIds: string[];
  records: TopicDataRecord[];
}

/** `ubii.processing.LockstepProcessingRequest` */
export interface LockstepProcessingRequest {
  processingModuleIds: string[];
  records: TopicDataRecord[];
  deltaTimeMs: number;
}

/** `ubii.processing.ModuleIO` */
export interface ModuleIO {
  internalName: string;
  messageFormat: string;
  isRecordList: boolean;
}

/** `ubii.processing.ProcessingMode` */
export interface ProcessingMode {
  frequency?: ProcessingModeFrequency | undefined;
  lockstep?: ProcessingModeLockstep | undefined;
  triggerOnInput?: ProcessingModeTriggerOnInput | undefined;
  free?: ProcessingModeFree | undefined;
}

/** `ubii.processing.ProcessingMode.Free` */
export interface ProcessingModeFree {
}

/** `ubii.processing.ProcessingMode.Frequency` */
export interface ProcessingModeFrequency {
  hertz: number;
}

/** `ubii.processing.ProcessingMode.Lockstep` */
export interface ProcessingModeLockstep {
  processRequestEndpoint: string;
}

/** `ubii.processing.ProcessingMode.TriggerOnInput` */
export interface ProcessingModeTriggerOnInput {
  minDelayMs: number;
  allInputsNeedUpdate: boolean;
}

/** `ubii.processing.ProcessingModule` */
export interface ProcessingModule {
  id: string;
  name: string;
  authors: string[];
  tags: string[];
  description: string;
  nodeId: string;
  sessionId: string;
  status: ProcessingModuleStatus;
  processingMode: ProcessingMode | undefined;
  inputs: ModuleIO[];
  outputs: ModuleIO[];
  language: ProcessingModuleLanguage;
  onProcessingStringified: string;
  onCreatedStringified: string;
  onHaltedStringified: string;
  onDestroyedStringified: string;
}

/** `ubii.processing.ProcessingModuleList` */
export interface ProcessingModuleList {
  elements: ProcessingModule[];
}

/** `ubii.servers.Server` */
export interface Server {
  id: string;
  name: string;
  ipEthernet: string;
  ipWlan: string;
  portServiceZmq: string;
  portServiceRest: string;
  portTopicDataZmq: string;
  portTopicDataWs: string;
  constantsJson: string;
  externalAddressServiceZmq: string;
  externalAddressServiceHttpJson: string;
  externalAddressServiceHttpBinary: string;
  externalAddressTopicDataZmq: string;
  externalAddressTopicDataWs: string;
}

/** `ubii.services.Service` */
export interface Service {
  topic: string;
  requestMessageFormat: string;
  responseMessageFormat: string;
  tags: string[];
  description: string;
}

/** `ubii.services.ServiceList` */
export interface ServiceList {
  elements: Service[];
}

/** `ubii.services.ServiceReply` */
export interface ServiceReply {
  success?: Success | undefined;
  error?: ErrorMessage | undefined;
  client?: Client | undefined;
  device?: Device | undefined;
  server?: Server | undefined;
  session?: Session | undefined;
  sessionList?: SessionList | undefined;
  processingModule?: ProcessingModule | undefined;
  processingModuleList?: ProcessingModuleList | undefined;
  stringList?: StringList | undefined;
  topicMux?: TopicMux | undefined;
  topicMuxList?: TopicMuxList | undefined;
  topicDemux?: TopicDemux | undefined;
  topicDemuxList?: TopicDemuxList | undefined;
  clientList?: ClientList | undefined;
  deviceList?: DeviceList | undefined;
  service?: Service | undefined;
  serviceList?: ServiceList | undefined;
  lockstepProcessingReply?: LockstepProcessingReply | undefined;
  component?: Component | undefined;
  componentList?: ComponentList | undefined;
  notifyCondition?: NotifyCondition | undefined;
  topicStatistics?: TopicStatistics | undefined;
  masterStatus?: MasterStatus | undefined;
}

/** `ubii.services.ServiceRequest` */
export interface ServiceRequest {
  topic: string;
  client?: Client | undefined;
  device?: Device | undefined;
  topicSubscription?: TopicSubscription | undefined;
  session?: Session | undefined;
  sessionList?: SessionList | undefined;
  processingModule?: ProcessingModule | undefined;
  processingModuleList?: ProcessingModuleList | undefined;
  topicMux?: TopicMux | undefined;
  topicMuxList?: TopicMuxList | undefined;
  topicDemux?: TopicDemux | undefined;
  topicDemuxList?: TopicDemuxList | undefined;
  clientList?: ClientList | undefined;
  deviceList?: DeviceList | undefined;
  lockstepProcessingRequest?: LockstepProcessingRequest | undefined;
  component?: Component | undefined;
  componentList?: ComponentList | undefined;
  notifyCondition?: NotifyCondition | undefined;
  topicStatisticsRequest?: TopicStatisticsRequest | undefined;
  masterStatusRequest?: MasterStatusRequest | undefined;
}

/** `ubii.services.request.TopicSubscription` */
export interface TopicSubscription {
  clientId: string;
  subscribeTopics: string[];
  unsubscribeTopics: string[];
  subscribeTopicRegexp: string[];
  unsubscribeTopicRegexp: string[];
  subscribeComponents: Component[];
  unsubscribeComponents: Component[];
  maxRateHz: number;
}

/** `ubii.sessions.IOMapping` */
export interface IOMapping {
  processingModuleId: string;
  inputMappings: TopicInputMapping[];
  outputMappings: TopicOutputMapping[];
  processingModuleName: string;
}

/** `ubii.sessions.IOMappingList` */
export interface IOMappingList {
  elements: IOMapping[];
}

/** `ubii.sessions.Session` */
export interface Session {
  id: string;
  name: string;
  processingModules: ProcessingModule[];
  ioMappings: IOMapping[];
  tags: string[];
  description: string;
  authors: string[];
  status: SessionStatus;
  editable: boolean;
}

/** `ubii.sessions.SessionList` */
export interface SessionList {
  elements: Session[];
}

/** `ubii.sessions.TopicInputMapping` */
export interface TopicInputMapping {
  inputName: string;
  topic?: string | undefined;
  topicMux?: TopicMux | undefined;
}

/** `ubii.sessions.TopicInputMappingList` */
export interface TopicInputMappingList {
  elements: TopicInputMapping[];
}

/** `ubii.sessions.TopicOutputMapping` */
export interface TopicOutputMapping {
  outputName: string;
  topic?: string | undefined;
  topicDemux?: TopicDemux | undefined;
}

/** `ubii.sessions.TopicOutputMappingList` */
export interface TopicOutputMappingList {
  elements: TopicOutputMapping[];
}

/** `ubii.topicData.Timestamp` */
export interface Timestamp {
  seconds: number;
  nanos: number;
  millis: number;
}

/** `ubii.topicData.TopicData` */
export interface TopicData {
  topicDataRecord?: TopicDataRecord | undefined;
  topicDataRecordList?: TopicDataRecordList | undefined;
  error?: ErrorMessage | undefined;
}

/** `ubii.topicData.TopicDataRecord` */
export interface TopicDataRecord {
  topic: string;
  timestamp: Timestamp | undefined;
  double?: number | undefined;
  bool?: boolean | undefined;
  string?: string | undefined;
  vector2?: Vector2 | undefined;
  vector3?: Vector3 | undefined;
  vector4?: Vector4 | undefined;
  quaternion?: Quaternion | undefined;
  matrix3x2?: Matrix3x2 | undefined;
  matrix4x4?: Matrix4x4 | undefined;
  color?: Color | undefined;
  touchEvent?: TouchEventMessage | undefined;
  keyEvent?: KeyEvent | undefined;
  mouseEvent?: MouseEventMessage | undefined;
  myoEvent?: MyoEvent | undefined;
  pose2D?: Pose2D | undefined;
  pose3D?: Pose3D | undefined;
  object2D?: Object2D | undefined;
  object3D?: Object3D | undefined;
  object2DList?: Object2DList | undefined;
  object3DList?: Object3DList | undefined;
  int32?: number | undefined;
  float?: number | undefined;
  int32List?: Int32List | undefined;
  floatList?: FloatList | undefined;
  doubleList?: DoubleList | undefined;
  stringList?: StringList | undefined;
  boolList?: BoolList | undefined;
  image2D?: Image2D | undefined;
  image2DList?: Image2DList | undefined;
  session?: Session | undefined;
  clientId: string;
  touchEventList?: TouchEventList | undefined;
  vector2List?: Vector2List | undefined;
  vector3List?: Vector3List | undefined;
  vector4List?: Vector4List | undefined;
  quaternionList?: Quaternion | undefined;
  error?: ErrorMessage | undefined;
  device?: Device | undefined;
  deviceList?: DeviceList | undefined;
  component?: Component | undefined;
  componentList?: ComponentList | undefined;
  sessionList?: SessionList | undefined;
  client?: Client | undefined;
}

/** `ubii.topicData.TopicDataRecordList` */
export interface TopicDataRecordList {
  elements: TopicDataRecord[];
}

/** `ubii.topicData.TopicDataSource` */
export interface TopicDataSource {
  topic?: string | undefined;
  regex?: string | undefined;
  component?: Component | undefined;
  staticRecord?: TopicDataRecord | undefined;
}

/** `ubii.topicData.TopicDataSourceList` */
export interface TopicDataSourceList {
  elements: TopicDataSource[];
}

/** Every message of the schema by its full name. */
export interface MessageTypes {
  'ubii.clients.Client': Client;
  'ubii.clients.ClientList': ClientList;
  'ubii.conditions.NotifyCondition': NotifyCondition;
  'ubii.dataStructure.BoolList': BoolList;
  'ubii.dataStructure.Color': Color;
  'ubii.dataStructure.DoubleList': DoubleList;
  'ubii.dataStructure.FloatList': FloatList;
  'ubii.dataStructure.Image2D': Image2D;
  'ubii.dataStructure.Image2DList': Image2DList;
  'ubii.dataStructure.Int32List': Int32List;
  'ubii.dataStructure.KeyEvent': KeyEvent;
  'ubii.dataStructure.Matrix3x2': Matrix3x2;
  'ubii.dataStructure.Matrix4x4': Matrix4x4;
  'ubii.dataStructure.MouseEvent': MouseEventMessage;
  'ubii.dataStructure.MyoEvent': MyoEvent;
  'ubii.dataStructure.Object2D': Object2D;
  'ubii.dataStructure.Object2DList': Object2DList;
  'ubii.dataStructure.Object3D': Object3D;
  'ubii.dataStructure.Object3DList': Object3DList;
  'ubii.dataStructure.Pose2D': Pose2D;
  'ubii.dataStructure.Pose3D': Pose3D;
  'ubii.dataStructure.Quaternion': Quaternion;
  'ubii.dataStructure.QuaternionList': QuaternionList;
  'ubii.dataStructure.StringList': StringList;
  'ubii.dataStructure.TouchEvent': TouchEventMessage;
  'ubii.dataStructure.TouchEventList': TouchEventList;
  'ubii.dataStructure.Vector2': Vector2;
  'ubii.dataStructure.Vector2List': Vector2List;
  'ubii.dataStructure.Vector3': Vector3;
  'ubii.dataStructure.Vector3List': Vector3List;
  'ubii.dataStructure.Vector4': Vector4;
  'ubii.dataStructure.Vector4List': Vector4List;
  'ubii.dataStructure.Vector8': Vector8;
  'ubii.dataStructure.Vector8List': Vector8List;
  'ubii.devices.Component': Component;
  'ubii.devices.ComponentList': ComponentList;
  'ubii.devices.Device': Device;
  'ubii.devices.DeviceList': DeviceList;
  'ubii.devices.TopicDemux': TopicDemux;
  'ubii.devices.TopicDemuxList': TopicDemuxList;
  'ubii.devices.TopicMux': TopicMux;
  'ubii.devices.TopicMuxList': TopicMuxList;
  'ubii.extension.ClientExtension': ClientExtension;
  'ubii.extension.MasterAddress': MasterAddress;
  'ubii.extension.MasterStatus': MasterStatus;
  'ubii.extension.MasterStatusRequest': MasterStatusRequest;
  'ubii.extension.StatusEvent': StatusEvent;
  'ubii.extension.StatusProblem': StatusProblem;
  'ubii.extension.StatusSample': StatusSample;
  'ubii.extension.TopicStatistic': TopicStatistic;
  'ubii.extension.TopicStatistics': TopicStatistics;
  'ubii.extension.TopicStatisticsRequest': TopicStatisticsRequest;
  'ubii.general.Error': ErrorMessage;
  'ubii.general.ErrorList': ErrorList;
  'ubii.general.Success': Success;
  'ubii.general.SuccessList': SuccessList;
  'ubii.processing.LockstepProcessingReply': LockstepProcessingReply;
  'ubii.processing.LockstepProcessingRequest': LockstepProcessingRequest;
  'ubii.processing.ModuleIO': ModuleIO;
  'ubii.processing.ProcessingMode': ProcessingMode;
  'ubii.processing.ProcessingMode.Free': ProcessingModeFree;
  'ubii.processing.ProcessingMode.Frequency': ProcessingModeFrequency;
  'ubii.processing.ProcessingMode.Lockstep': ProcessingModeLockstep;
  'ubii.processing.ProcessingMode.TriggerOnInput': ProcessingModeTriggerOnInput;
  'ubii.processing.ProcessingModule': ProcessingModule;
  'ubii.processing.ProcessingModuleList': ProcessingModuleList;
  'ubii.servers.Server': Server;
  'ubii.services.Service': Service;
  'ubii.services.ServiceList': ServiceList;
  'ubii.services.ServiceReply': ServiceReply;
  'ubii.services.ServiceRequest': ServiceRequest;
  'ubii.services.request.TopicSubscription': TopicSubscription;
  'ubii.sessions.IOMapping': IOMapping;
  'ubii.sessions.IOMappingList': IOMappingList;
  'ubii.sessions.Session': Session;
  'ubii.sessions.SessionList': SessionList;
  'ubii.sessions.TopicInputMapping': TopicInputMapping;
  'ubii.sessions.TopicInputMappingList': TopicInputMappingList;
  'ubii.sessions.TopicOutputMapping': TopicOutputMapping;
  'ubii.sessions.TopicOutputMappingList': TopicOutputMappingList;
  'ubii.topicData.Timestamp': Timestamp;
  'ubii.topicData.TopicData': TopicData;
  'ubii.topicData.TopicDataRecord': TopicDataRecord;
  'ubii.topicData.TopicDataRecordList': TopicDataRecordList;
  'ubii.topicData.TopicDataSource': TopicDataSource;
  'ubii.topicData.TopicDataSourceList': TopicDataSourceList;
}
