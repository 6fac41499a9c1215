import type { EnumDescriptor, FieldDescriptor, MessageDescriptor } from '../descriptor.ts';
import { isBytes } from '../binary/is-bytes.ts';
import { validateImage } from './validate-image.ts';

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
