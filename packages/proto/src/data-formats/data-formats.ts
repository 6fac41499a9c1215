import {
  FIRST_EXTENSION_FIELD,
  messageDescriptor,
  type FieldDescriptor,
  type MessageDescriptor,
} from '../descriptor.ts';
import type { DataFormat, DataFormatValues } from './data-format-values.ts';
import { validateValue } from './validate-value.ts';

/** Values that differ from all zeros, because zeros would not be a rotation or not be visible. */
const NEUTRAL_MEMBERS: { readonly [messageType: string]: { readonly [member: string]: unknown } } =
  {
    'ubii.dataStructure.Quaternion': { w: 1 },
    'ubii.dataStructure.Matrix3x2': { m00: 1, m11: 1 },
    'ubii.dataStructure.Matrix4x4': { m00: 1, m11: 1, m22: 1, m33: 1 },
    'ubii.dataStructure.Color': { a: 1 },
  };

/** Members of oneofs that a neutral value sets. */
const NEUTRAL_CHOICE: { readonly [messageType: string]: string } = {
  'ubii.dataStructure.Pose2D': 'angle',
  'ubii.dataStructure.Pose3D': 'quaternion',
};

/**
 * A new neutral value of a type: zeros, empty lists and texts, nested messages filled in, identity
 * rotations, opaque black. Members of a oneof are left out, except the orientation of a pose, and so
 * are messages that are extensions of ours, because their presence says something.
 */
function neutralValue(type: FieldDescriptor['type']): unknown {
  if (typeof type === 'object') return type.kind === 'enum' ? 0 : neutralMessage(type);
  if (type === 'string') return '';
  if (type === 'bool') return false;
  if (type === 'bytes') return new Uint8Array(0);
  return 0;
}

function neutralMessage({ name, fields }: MessageDescriptor): object {
  const message: Record<string, unknown> = {};
  for (const { jsonName, number, oneof, repeated, type } of fields) {
    if (oneof !== undefined && NEUTRAL_CHOICE[name] !== jsonName) continue;
    const isOurMessage = number >= FIRST_EXTENSION_FIELD && typeof type === 'object';
    if (repeated) message[jsonName] = [];
    else message[jsonName] = isOurMessage ? undefined : neutralValue(type);
  }
  return Object.assign(message, NEUTRAL_MEMBERS[name]);
}

/** Families of data formats that look and combine alike; each has a colour and a socket shape. */
export type DataFormatFamily =
  | 'number'
  | 'vector'
  | 'rotation'
  | 'event'
  | 'text'
  | 'image'
  | 'objects'
  | 'pose'
  | 'system';

/** Facts about one data format. */
export interface DataFormatInfo<F extends DataFormat = DataFormat> {
  readonly format: F;
  /** Number of the member in `TopicDataRecord`. */
  readonly fieldNumber: number;
  /** Full name of the message, `ubii.dataStructure.Vector2`, or of the scalar, `double`. */
  readonly messageType: string;
  readonly family: DataFormatFamily;
  /** The value has an `elements` array. */
  readonly isList: boolean;
  /** Every record counts, not only the newest: a slow subscriber gets all of them. [TD-31] */
  readonly isEvent: boolean;
  /** A new neutral value: zeros, empty lists, identity rotations, opaque black. */
  createDefault(): DataFormatValues[F];
  /** Undefined when the value is of this format, else one sentence that names the member. */
  validate(value: unknown): string | undefined;
}

const FAMILIES: { readonly [F in DataFormat]: DataFormatFamily } = {
  double: 'number',
  float: 'number',
  int32: 'number',
  doubleList: 'number',
  floatList: 'number',
  int32List: 'number',
  vector2: 'vector',
  vector2List: 'vector',
  vector3: 'vector',
  vector3List: 'vector',
  vector4: 'vector',
  vector4List: 'vector',
  color: 'vector',
  quaternion: 'rotation',
  quaternionList: 'rotation',
  matrix3x2: 'rotation',
  matrix4x4: 'rotation',
  bool: 'event',
  boolList: 'event',
  touchEvent: 'event',
  touchEventList: 'event',
  keyEvent: 'event',
  mouseEvent: 'event',
  myoEvent: 'event',
  string: 'text',
  stringList: 'text',
  image2D: 'image',
  image2DList: 'image',
  object2D: 'objects',
  object2DList: 'objects',
  object3D: 'objects',
  object3DList: 'objects',
  pose2D: 'pose',
  pose3D: 'pose',
  session: 'system',
  sessionList: 'system',
  device: 'system',
  deviceList: 'system',
  component: 'system',
  componentList: 'system',
  error: 'system',
  client: 'system',
  sessionStatistics: 'system',
  moduleEvent: 'system',
  recordingStatus: 'system',
  replayList: 'system',
  studyStatus: 'system',
};

/** A `bool` shows like an event, but its newest value is all that matters. */
const EVENTS: ReadonlySet<string> = new Set([
  'touchEvent',
  'touchEventList',
  'keyEvent',
  'mouseEvent',
  'myoEvent',
  'moduleEvent',
]);

const RECORD = messageDescriptor('ubii.topicData.TopicDataRecord');

function info(field: FieldDescriptor): DataFormatInfo {
  const { jsonName, number, type } = field;
  const format = jsonName as DataFormat;
  const fields = typeof type === 'object' && type.kind === 'message' ? type.fields : [];
  return {
    format,
    fieldNumber: number,
    messageType: typeof type === 'string' ? type : type.name,
    family: FAMILIES[format],
    isList: fields.length === 1 && fields[0]!.repeated,
    isEvent: EVENTS.has(format),
    createDefault: () => neutralValue(type) as DataFormatValues[DataFormat],
    validate: (value) => validateValue(type, value, format),
  };
}

const INFOS = RECORD.fields.filter((field) => field.oneof !== undefined).map(info);
const FORMAT_BY_FIELD = new Map(INFOS.map(({ fieldNumber, format }) => [fieldNumber, format]));

/** Every data format by its short name, in the order of the field numbers. */
export const DATA_FORMATS = Object.fromEntries(
  INFOS.map((entry) => [entry.format, entry]),
) as unknown as { readonly [F in DataFormat]: DataFormatInfo<F> };

/** True for the exact short name of a data format; `parseDataFormat` is the lenient way. */
export function isDataFormat(text: string): text is DataFormat {
  return Object.hasOwn(DATA_FORMATS, text);
}

/** The data format of a member of `TopicDataRecord`; undefined when the number is not a value's. */
export function dataFormatOfField(fieldNumber: number): DataFormat | undefined {
  return FORMAT_BY_FIELD.get(fieldNumber);
}
