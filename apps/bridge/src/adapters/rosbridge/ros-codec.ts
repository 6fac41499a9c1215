import type { DataFormat } from '@ubii/proto';
import type { PayloadCodec } from '../../core/payload/payload-codec.ts';
import { toValue } from '../../core/payload/plain-values.ts';
import type { RosMessage } from './ros-message.ts';
import { ROS_TYPES } from './ros-types.ts';
import type { RosType } from './ros-types.ts';

/** Values of topics as messages of ROS, and back. [BR-70] */
export const rosCodec: PayloadCodec<RosMessage> = {
  read(message, { format, rosType }) {
    if (format === undefined) throw new Error('The mapping has no data format.');
    const json = typeOf(rosType).read(message, format);
    const value = format === 'image2D' ? checkedImage(json) : valueOf(format, json);
    return { format, value, timestampMs: stampOf(message) };
  },
  write({ format, value }, { rosType }) {
    const type = typeOf(rosType);
    if (!type.formats.includes(format)) {
      throw new Error(`${rosType} carries ${type.formats.join(', ')}, not ${format}.`);
    }
    const message = type.write(value, format);
    if (hasNumberNotInJson(message)) {
      throw new Error('rosbridge carries no NaN and no infinity, and the message has one.');
    }
    return message;
  },
};

function typeOf(rosType: string): RosType {
  const type = ROS_TYPES[rosType];
  if (type === undefined) throw new Error(`The message type ${rosType} is not supported.`);
  return type;
}

/** Bytes are no JSON. */
function checkedImage(json: unknown): unknown {
  const { data, ...rest } = json as { readonly data: Uint8Array };
  const empty = toValue('image2D', { ...rest, width: 0, height: 0 }) as object;
  return { ...empty, ...rest, data };
}

function valueOf(format: DataFormat, json: unknown): unknown {
  if (format === 'string' || format === 'bool') return toValue(format, json);
  const numbers = withNaN(json);
  const isPlain = typeof numbers === 'number' && format !== 'int32';
  return isPlain ? numbers : toValue(format, numbers);
}

/** rosbridge writes NaN and infinities as null, because JSON has none. Their places stay, so that lists keep their order. [BR-72] */
function withNaN(json: unknown): unknown {
  if (json === null) return Number.NaN;
  if (typeof json === 'bigint') return Number(json);
  if (Array.isArray(json)) return json.map(withNaN);
  if (typeof json !== 'object') return json;
  return Object.fromEntries(Object.entries(json).map(([name, member]) => [name, withNaN(member)]));
}

function hasNumberNotInJson(json: unknown): boolean {
  if (typeof json === 'number') return !Number.isFinite(json);
  return typeof json === 'object' && json !== null && Object.values(json).some(hasNumberNotInJson);
}

/** Time of the header, milliseconds since the Unix epoch; ROS 1 has `secs`, ROS 2 `sec`. */
function stampOf({ header }: RosMessage): number | undefined {
  const { stamp } = (header ?? {}) as { readonly stamp?: Readonly<Record<string, unknown>> };
  const seconds = Number(stamp?.['sec'] ?? stamp?.['secs']);
  const nanoseconds = Number(stamp?.['nanosec'] ?? stamp?.['nsecs'] ?? 0);
  // Messages without a timestamp have 0.
  return seconds > 0 && nanoseconds >= 0 ? seconds * 1_000 + nanoseconds / 1e6 : undefined;
}
