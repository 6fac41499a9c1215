import { isBytes } from '../binary/is-bytes.ts';
import type { EnumDescriptor, FieldDescriptor, MessageDescriptor } from '../descriptor.ts';
import { Image2DDataFormat } from '../generated/messages.ts';

const CHANNELS: { readonly [dataFormat: number]: number } = {
  [Image2DDataFormat.GRAY8]: 1,
  [Image2DDataFormat.RGB8]: 3,
  [Image2DDataFormat.RGBA8]: 4,
};

/**
 * First bytes of the compressed pictures that clients send in `data` although the schema has no
 * format for them: JPEG, PNG, and WebP (a RIFF container).
 */
const COMPRESSED_STARTS: readonly (readonly number[])[] = [
  [0xff, 0xd8, 0xff],
  [0x89, 0x50, 0x4e, 0x47],
  [0x52, 0x49, 0x46, 0x46],
];

/**
 * Checks that a picture has as many bytes as its size says: width times height times channels.
 * Compressed pictures, known by their first bytes, are not measured: their data says its own size.
 *
 * @returns undefined when fine, else one sentence
 */
function validateImage(image: Readonly<Record<string, unknown>>, name: string): string | undefined {
  const width = Number(image['width'] ?? 0);
  const height = Number(image['height'] ?? 0);
  const channels = CHANNELS[Number(image['dataFormat'] ?? 0)] ?? 0;
  const data = (image['data'] ?? new Uint8Array(0)) as Uint8Array;
  if (width < 0 || height < 0)
    return `${name} must not be smaller than 0 by 0, got ${width} by ${height}.`;
  if (isCompressedImage(data)) return undefined;
  const expected = width * height * channels;
  if (data.length === expected) return undefined;
  return `${name}.data must be ${expected} bytes for ${width} by ${height} pixels of ${channels} bytes, got ${data.length}.`;
}

/** True when the data of a picture begins like a JPEG, PNG or WebP file. */
export function isCompressedImage(data: Uint8Array): boolean {
  return COMPRESSED_STARTS.some((start) => start.every((byte, i) => data[i] === byte));
}

const MIN_INT32 = -(2 ** 31);
const MAX_INT32 = 2 ** 31 - 1;

/**
 * Checks a value against the schema. Members that are left out are fine, as they are when encoding;
 * so are members the schema does not know, as long as there is one it does.
 *
 * @param name what to call the value in the sentence
 * @returns undefined when fine, else one sentence that names the member
 */
export function validateValue(
  type: FieldDescriptor['type'],
  value: unknown,
  name: string,
): string | undefined {
  if (typeof type === 'object') {
    return type.kind === 'enum'
      ? validateEnum(type, value, name)
      : validateMessage(type, value, name);
  }
  switch (type) {
    case 'double':
    case 'float':
      return typeof value === 'number' ? undefined : wrong(name, 'a number', value);
    case 'int32':
      return Number.isInteger(value) && Number(value) >= MIN_INT32 && Number(value) <= MAX_INT32
        ? undefined
        : wrong(name, 'an integer of 32 bits', value);
    case 'int64':
      return Number.isSafeInteger(value) ? undefined : wrong(name, 'an integer', value);
    case 'bool':
      return typeof value === 'boolean' ? undefined : wrong(name, 'true or false', value);
    case 'string':
      return typeof value === 'string' ? undefined : wrong(name, 'text', value);
    case 'bytes':
      return isBytes(value) ? undefined : wrong(name, 'a Uint8Array', value);
  }
}

function validateEnum(type: EnumDescriptor, value: unknown, name: string): string | undefined {
  if (typeof value === 'number' && type.nameByNumber.has(value)) return undefined;
  const options = [...type.nameByNumber].map(([number, option]) => `${number} (${option})`);
  return wrong(name, `one of ${options.join(', ')}`, value);
}

function validateMessage(
  type: MessageDescriptor,
  value: unknown,
  name: string,
): string | undefined {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    return wrong(name, `an object with ${membersOf(type)}`, value);
  }
  const message = value as Record<string, unknown>;
  const chosen = new Map<string, string>();
  let known = 0;
  for (const field of type.fields) {
    const member = message[field.jsonName];
    if (member === undefined || member === null) continue;
    known++;
    const memberName = `${name}.${field.jsonName}`;
    const problem = field.repeated
      ? validateList(field, member, memberName)
      : validateValue(field.type, member, memberName);
    if (problem !== undefined) return problem;
    if (field.oneof === undefined) continue;
    const other = chosen.get(field.oneof);
    if (other !== undefined) return `${name} has both ${other} and ${field.jsonName}; give one.`;
    chosen.set(field.oneof, field.jsonName);
  }
  if (known === 0 && type.fields.length > 0 && Object.keys(message).length > 0) {
    return wrong(name, `an object with ${membersOf(type)}`, value);
  }
  return type.name === 'ubii.dataStructure.Image2D' ? validateImage(message, name) : undefined;
}

function validateList(field: FieldDescriptor, value: unknown, name: string): string | undefined {
  const isNumeric = typeof field.type === 'string' && field.type !== 'string';
  if (!Array.isArray(value) && !(isNumeric && ArrayBuffer.isView(value))) {
    return wrong(name, 'an array', value);
  }
  const elements = value as ArrayLike<unknown>;
  for (let i = 0; i < elements.length; i++) {
    const problem = validateValue(field.type, elements[i], `${name}[${i}]`);
    if (problem !== undefined) return problem;
  }
  return undefined;
}

function membersOf(type: MessageDescriptor): string {
  return type.fields.map((field) => field.jsonName).join(', ');
}

function wrong(name: string, expected: string, received: unknown): string {
  return `${name} must be ${expected}, got ${describe(received)}.`;
}

function describe(value: unknown): string {
  if (value === null) return 'null';
  if (Array.isArray(value)) return `an array of ${value.length}`;
  if (typeof value === 'string')
    return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}…` : value);
  if (typeof value === 'object') {
    const keys = Object.keys(value).slice(0, 5);
    return keys.length === 0 ? 'an empty object' : `an object with ${keys.join(', ')}`;
  }
  return String(value);
}
