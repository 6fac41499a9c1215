import {
  FIRST_EXTENSION_FIELD,
  type FieldDescriptor,
  type MessageDescriptor,
} from '../descriptor.ts';

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
export function neutralValue(type: FieldDescriptor['type']): unknown {
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
