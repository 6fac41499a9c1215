import type {
  BoolList,
  Client,
  Color,
  Component,
  ComponentList,
  Device,
  DeviceList,
  DoubleList,
  ErrorMessage,
  FloatList,
  Image2D,
  Image2DList,
  Int32List,
  KeyEvent,
  Matrix3x2,
  Matrix4x4,
  ModuleEvent,
  MouseEventMessage,
  MyoEvent,
  Object2D,
  Object2DList,
  Object3D,
  Object3DList,
  Pose2D,
  Pose3D,
  Quaternion,
  RecordingStatus,
  ReplayList,
  Session,
  SessionList,
  SessionStatistics,
  StringList,
  StudyStatus,
  TouchEventList,
  TouchEventMessage,
  Vector2,
  Vector2List,
  Vector3,
  Vector3List,
  Vector4,
  Vector4List,
} from '../generated/messages.ts';

/**
 * The closed list of what a topic can carry: the value members of `TopicDataRecord` by their JSON
 * names, each with the type of its value. Units and meaning are at the message types.
 */
export interface DataFormatValues {
  double: number;
  bool: boolean;
  string: string;
  /** Integer from -2^31 to 2^31 - 1. */
  int32: number;
  /** Single precision. */
  float: number;
  vector2: Vector2;
  vector2List: Vector2List;
  vector3: Vector3;
  vector3List: Vector3List;
  vector4: Vector4;
  vector4List: Vector4List;
  quaternion: Quaternion;
  /**
   * One quaternion, not a list: the member of the record has this type since the first release of
   * the protocol, and changing it would break every deployed client.
   */
  quaternionList: Quaternion;
  matrix3x2: Matrix3x2;
  matrix4x4: Matrix4x4;
  color: Color;
  touchEvent: TouchEventMessage;
  touchEventList: TouchEventList;
  keyEvent: KeyEvent;
  mouseEvent: MouseEventMessage;
  myoEvent: MyoEvent;
  pose2D: Pose2D;
  pose3D: Pose3D;
  object2D: Object2D;
  object3D: Object3D;
  object2DList: Object2DList;
  object3DList: Object3DList;
  int32List: Int32List;
  floatList: FloatList;
  doubleList: DoubleList;
  stringList: StringList;
  boolList: BoolList;
  image2D: Image2D;
  image2DList: Image2DList;
  session: Session;
  sessionList: SessionList;
  device: Device;
  deviceList: DeviceList;
  component: Component;
  componentList: ComponentList;
  error: ErrorMessage;
  /** Extension of ours: news about a client on `/ubii/client/<client id>`. */
  client: Client;
  /** Extension of ours: how a running session does, on `/ubii/session/<session id>/statistics`. [SE-50] */
  sessionStatistics: SessionStatistics;
  /** Extension of ours: what a running module did, on `/ubii/session/<session id>/events`. [SE-51] */
  moduleEvent: ModuleEvent;
  recordingStatus: RecordingStatus;
  replayList: ReplayList;
  studyStatus: StudyStatus;
}

/** Short name of a data format, for example `vector2`. */
export type DataFormat = keyof DataFormatValues;
