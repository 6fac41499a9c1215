import { SERVICES } from './services/services.ts';

/** Topics by the keys of the original constants. The patterns are regular expressions by intention. */
const LEGACY_INFO_TOPICS = {
  REGEX_ALL_INFOS: '/info/*',
  REGEX_PM_INFOS: '/info/processing_module/*',
  NEW_PM: '/info/processing_module/new',
  START_PM: '/info/processing_module/start',
  DELETE_PM: '/info/processing_module/delete',
  CHANGE_PM: '/info/processing_module/change',
  PROCESSED_PM: '/info/processing_module/processed',
  REGEX_SESSION_INFOS: '/info/session/*',
  NEW_SESSION: '/info/session/new',
  DELETE_SESSION: '/info/session/delete',
  CHANGE_SESSION: '/info/session/change',
  START_SESSION: '/info/session/start',
  STOP_SESSION: '/info/session/stop',
  RUNNING_SESSION: '/info/session/running',
};

/** Message names by the keys of the original constants, misspelt ones included. */
const LEGACY_MESSAGE_TYPES = {
  ERROR: 'ubii.general.Error',
  SUCCESS: 'ubii.general.Success',
  SERVER: 'ubii.servers.Server',
  CLIENT: 'ubii.clients.Client',
  CLIENT_LIST: 'ubii.clients.ClientList',
  DEVICE: 'ubii.devices.Device',
  DEVICE_LIST: 'ubii.devices.DeviceList',
  COMPONENT: 'ubii.devices.Component',
  COMPONENT_LIST: 'ubii.devices.ComponentList',
  TOPIC_MUX: 'ubii.devices.TopicMux',
  TOPIC_MUX_LIST: 'ubii.devices.TopicMuxList',
  TOPIC_DEMUX: 'ubii.devices.TopicDemux',
  TOPIC_DEMUX_LIST: 'ubii.devices.TopicDemuxList',
  SERVICE: 'ubii.services.Service',
  SERVICE_LIST: 'ubii.services.ServiceList',
  SERVICE_REQUEST: 'ubii.services.ServiceRequest',
  SERVICE_REPLY: 'ubii.services.ServiceReply',
  SERVICE_REUEST_TOPIC_SUBSCRIPTION: 'ubii.services.request.TopicSubscription',
  SESSION: 'ubii.sessions.Session',
  SESSION_LIST: 'ubii.sessions.SessionList',
  SESSION_IO_MAPPING: 'ubii.sessions.IOMapping',
  PM: 'ubii.processing.ProcessingModule',
  PM_LIST: 'ubii.processing.ProcessingModuleList',
  PM_MODULE_IO: 'ubii.processing.ModuleIO',
  PM_PROCESSING_MODE: 'ubii.processing.ProcessingMode',
  TOPIC_DATA: 'ubii.topicData.TopicData',
  TOPIC_DATA_RECORD: 'ubii.topicData.TopicDataRecord',
  TOPIC_DATA_RECORD_LIST: 'ubii.topicData.TopicDataRecordList',
  TOPIC_DATA_TIMESTAMP: 'ubii.topicData.Timestamp',
  DATASTRUCTURE_BOOL: 'bool',
  DATASTRUCTURE_BOOL_LIST: 'ubii.dataStructure.BoolList',
  DATASTRUCTURE_INT32: 'int32',
  DATASTRUCTURE_INT32_LIST: 'ubii.dataStructure.Int32List',
  DATASTRUCTURE_STRING: 'string',
  DATASTRUCTURE_STRING_LIST: 'ubii.dataStructure.StringList',
  DATASTRUCTURE_FLOAT: 'float',
  DATASTRUCTURE_FLOAT_LIST: 'ubii.dataStructure.FloatList',
  DATASTRUCTURE_DOUBLE: 'double',
  DATASTRUCTURE_DOUBLE_LIST: 'ubii.dataStructure.DoubleList',
  DATASTRUCTURE_COLOR: 'ubii.dataStructure.Color',
  DATASTRUCTURE_IMAGE: 'ubii.dataStructure.Image2D',
  DATASTRUCTURE_IMAGE_LIST: 'ubii.dataStructure.Image2DList',
  DATASTRUCTURE_KEY_EVENT: 'ubii.dataStructure.KeyEvent',
  DATASTRUCTURE_MATRIX_3X2: 'ubii.dataStructure.Matrix3x2',
  DATASTRUCTURE_MATRIX_4X4: 'ubii.dataStructure.Matrix4x4',
  DATASTRUCTURE_MOUSE_EVENT: 'ubii.dataStructure.MouseEvent',
  DATASTRUCTURE_OBJECT2D: 'ubii.dataStructure.Object2D',
  DATASTRUCTURE_OBJECT2D_LIST: 'ubii.dataStructure.Object2DList',
  DATASTRUCTURE_OBJECT3D: 'ubii.dataStructure.Object3D',
  DATASTRUCTURE_OBJECT3D_LIST: 'ubii.dataStructure.Object3DList',
  DATASTRUCTURE_POSE2D: 'ubii.dataStructure.Pose2D',
  DATASTRUCTURE_POSE3D: 'ubii.dataStructure.Pose3D',
  DATASTRUCTURE_QUATERNION: 'ubii.dataStructure.Quaternion',
  DATASTRUCTURE_TOUCH_EVENT: 'ubii.dataStructure.TouchEvent',
  DATASTRUCTURE_VECTOR2: 'ubii.dataStructure.Vector2',
  DATASTRUCTURE_VECTOR3: 'ubii.dataStructure.Vector3',
  DATASTRUCTURE_VECTOR4: 'ubii.dataStructure.Vector4',
  DATASTRUCTURE_VECTOR8: 'ubii.dataStructure.Vector8',
};

/**
 * The object that `Server.constants_json` holds as JSON text. The strictest client, the Python node
 * 0.3.0, refuses to connect when it meets a key it does not know: so nothing of ours is in here, and
 * none of the keys that later releases of the original added (notify conditions, device infos). [SV-10]
 */
export const LEGACY_CONSTANTS = {
  DEFAULT_TOPICS: {
    SERVICES: Object.fromEntries(
      Object.values(SERVICES).flatMap(({ constant, topic }) =>
        constant === undefined ? [] : [[constant, topic]],
      ),
    ) as Readonly<Record<string, string>>,
    INFO_TOPICS: LEGACY_INFO_TOPICS,
  },
  MSG_TYPES: LEGACY_MESSAGE_TYPES,
} as const;
