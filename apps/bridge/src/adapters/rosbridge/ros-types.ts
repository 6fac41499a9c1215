import { isCompressedImage } from '@ubii/proto';
import type { DataFormat, Image2D } from '@ubii/proto';
import { NUMBER_MEMBERS } from '../../core/payload/members.ts';
import { fromRosImage, rosBytes, toRosImage } from './ros-images.ts';
import type { RosMessage } from './ros-message.ts';

/** How messages of one type are values of one format. */
export interface RosType {
  readonly formats: readonly DataFormat[];
  /** Returns the value as JSON; what is not there is refused later. */
  read(message: RosMessage, format: DataFormat): unknown;
  write(value: unknown, format: DataFormat): RosMessage;
}

const NUMBERS: readonly DataFormat[] = ['double', 'float', 'int32'];

/** `data` of messages with one member. */
function single(formats: readonly DataFormat[], round: (value: unknown) => unknown): RosType {
  return {
    formats,
    read: ({ data }) => data,
    write: (value) => ({ data: round(value) }),
  };
}

function whole(least: number, most: number): RosType {
  return single(NUMBERS, (value) => {
    const number = Math.round(Number(value));
    if (number >= least && number <= most) return number;
    throw new Error(`Expected a number from ${least} to ${most}, got ${String(value)}.`);
  });
}

/** JSON carries integers exactly up to 2^53 only: others would be another number. [BR-72] */
const int64: RosType = {
  ...whole(Number.MIN_SAFE_INTEGER, Number.MAX_SAFE_INTEGER),
  read({ data }) {
    const isNumber = typeof data === 'number' || typeof data === 'bigint';
    if (!isNumber || Number.isSafeInteger(Number(data))) return data;
    throw new Error(`Expected a whole number below 2^53, got ${data}.`);
  },
};

function list(format: DataFormat, round: (value: number) => number): RosType {
  return {
    formats: [format],
    read: ({ data }) => ({ elements: listOf(data) }),
    write: (value) => ({
      layout: { dim: [], data_offset: 0 },
      data: (value as { readonly elements: readonly number[] }).elements.map(round),
    }),
  };
}

function numbers(format: DataFormat): RosType {
  const members = NUMBER_MEMBERS[format] ?? [];
  return {
    formats: [format],
    read: (message) => Object.fromEntries(members.map((member) => [member, message[member]])),
    write: (value) => {
      const values = value as Readonly<Record<string, number>>;
      return Object.fromEntries(members.map((member) => [member, values[member] ?? 0]));
    },
  };
}

const pose: RosType = {
  formats: ['pose3D'],
  read: ({ position, orientation }) => ({ position, quaternion: orientation }),
  write: (value) => {
    const { position, quaternion } = value as Readonly<Record<string, RosMessage | undefined>>;
    if (quaternion === undefined) throw new Error('The pose has no quaternion.');
    return {
      position: vector3.write(position ?? {}, 'vector3'),
      orientation: quaternionType.write(quaternion, 'quaternion'),
    };
  },
};

/** Linear x, y, z in metres per second, angular x, y, z in radians per second. */
const twist: RosType = {
  formats: ['doubleList'],
  read: ({ linear, angular }) => ({
    elements: [linear, angular].flatMap((part) => {
      const { x, y, z } = (part ?? {}) as RosMessage;
      return [x, y, z];
    }),
  }),
  write: (value) => {
    const { elements } = value as { readonly elements: readonly number[] };
    if (elements.length !== 6) throw new Error(`Expected 6 numbers, got ${elements.length}.`);
    const [x, y, z, roll, pitch, yaw] = elements;
    return { linear: { x, y, z }, angular: { x: roll, y: pitch, z: yaw } };
  },
};

/** Axes as `floatList`, buttons as `int32List`. */
const joy: RosType = {
  formats: ['floatList', 'int32List'],
  read: ({ axes, buttons }, format) => ({
    elements: listOf(format === 'floatList' ? axes : buttons),
  }),
  write: (value, format) => {
    const { elements } = value as { readonly elements: readonly number[] };
    const isAxes = format === 'floatList';
    return { axes: isAxes ? [...elements] : [], buttons: isAxes ? [] : [...elements] };
  },
};

const image: RosType = { formats: ['image2D'], read: fromRosImage, write: toRosImage };

const compressedImage: RosType = {
  formats: ['image2D'],
  read: ({ data }) => ({ width: 0, height: 0, dataFormat: 0, data: rosBytes(data) }),
  write: (value) => {
    const { data } = value as Image2D;
    if (!isCompressedImage(data)) throw new Error('The picture is not compressed.');
    const kind = data[0] === 0x89 ? 'png' : data[0] === 0x52 ? 'webp' : 'jpeg';
    return { format: kind, data: Buffer.from(data).toString('base64') };
  },
};

/** A message with a header around another one, at a member, or beside its members. */
function stamped(type: RosType, member?: string): RosType {
  return {
    formats: type.formats,
    read: (message, format) =>
      type.read(member === undefined ? message : ((message[member] ?? {}) as RosMessage), format),
    write: (value, format) => {
      const written = type.write(value, format);
      const header = { frame_id: '' };
      return { header, ...(member === undefined ? written : { [member]: written }) };
    },
  };
}

const same = (value: unknown): unknown => value;
const float = single(NUMBERS, (value) => Math.fround(Number(value)));
const vector3 = numbers('vector3');
const quaternionType = numbers('quaternion');

/** Types that a mapping can name, as ROS 1 writes them. [BR-70] */
export const ROS_TYPES: Readonly<Record<string, RosType>> = {
  'std_msgs/Bool': single(['bool'], Boolean),
  'std_msgs/String': single(['string'], same),
  'std_msgs/Float64': single(NUMBERS, same),
  'std_msgs/Float32': float,
  'std_msgs/Int8': whole(-128, 127),
  'std_msgs/UInt8': whole(0, 255),
  'std_msgs/Int16': whole(-32_768, 32_767),
  'std_msgs/UInt16': whole(0, 65_535),
  'std_msgs/Int32': whole(-(2 ** 31), 2 ** 31 - 1),
  'std_msgs/UInt32': whole(0, 2 ** 32 - 1),
  'std_msgs/Int64': int64,
  'std_msgs/ColorRGBA': numbers('color'),
  'std_msgs/Float64MultiArray': list('doubleList', (value) => value),
  'std_msgs/Float32MultiArray': list('floatList', Math.fround),
  'std_msgs/Int32MultiArray': list('int32List', (value) => value),
  'geometry_msgs/Vector3': vector3,
  'geometry_msgs/Vector3Stamped': stamped(vector3, 'vector'),
  'geometry_msgs/Point': vector3,
  'geometry_msgs/PointStamped': stamped(vector3, 'point'),
  'geometry_msgs/Quaternion': quaternionType,
  'geometry_msgs/QuaternionStamped': stamped(quaternionType, 'quaternion'),
  'geometry_msgs/Pose': pose,
  'geometry_msgs/PoseStamped': stamped(pose, 'pose'),
  'geometry_msgs/Twist': twist,
  'geometry_msgs/TwistStamped': stamped(twist, 'twist'),
  'sensor_msgs/Joy': stamped(joy),
  'sensor_msgs/Image': stamped(image),
  'sensor_msgs/CompressedImage': stamped(compressedImage),
};

function listOf(value: unknown): readonly unknown[] {
  if (Array.isArray(value)) return value as readonly unknown[];
  // Of CBOR
  if (ArrayBuffer.isView(value) && !(value instanceof DataView)) {
    return [...(value as unknown as Iterable<unknown>)];
  }
  throw new Error('Expected a list of numbers.');
}
