import type { MessageType } from '../codec.ts';
import {
  FIRST_EXTENSION_FIELD,
  messageDescriptor,
  type FieldDescriptor,
  type MessageDescriptor,
} from '../descriptor.ts';
import type { MessageTypes } from '../generated/messages.ts';
import type { Init } from '../init.ts';
import { formatBase64 } from './base64.ts';

/** A JSON object as `JSON.parse` makes it. */
export type JsonObject = { [key: string]: JsonValue };

/**
 * Any JSON value. Text stands before truth values: Vue takes the order of a prop's types as the
 * order to try, and with `boolean` first it makes `true` of an empty text.
 */
export type JsonValue = null | string | number | boolean | JsonValue[] | JsonObject;

/**
 * Writes a message as JSON the way existing clients read it: camelCase keys, enum names, 64-bit
 * integers as text, bytes as base64. Scalar defaults and empty lists are written, unset messages and
 * unset members of oneofs are not; fields of our own only when they are not empty. [SV-4]
 *
 * @throws TypeError when a member has the wrong type
 */
export function toJson<T extends MessageType>(type: T, message: Init<MessageTypes[T]>): JsonObject {
  return writeMessage(messageDescriptor(type), message);
}

function writeMessage(type: MessageDescriptor, message: object): JsonObject {
  const json: JsonObject = {};
  const members = message as Readonly<Record<string, unknown>>;
  for (const field of type.fields) {
    const value = writeMember(field, members[field.jsonName]);
    if (value !== undefined) json[field.jsonName] = value;
  }
  return json;
}

function writeMember(field: FieldDescriptor, member: unknown): JsonValue | undefined {
  const isOurs = field.number >= FIRST_EXTENSION_FIELD;
  if (field.repeated) {
    const elements = Array.from((member ?? []) as ArrayLike<unknown>);
    if (isOurs && elements.length === 0) return undefined;
    return elements.map((element) => writeValue(field.type, element));
  }
  if (member === undefined || member === null) {
    const hasDefault = field.oneof === undefined && !isMessageField(field) && !isOurs;
    return hasDefault ? defaultOf(field.type) : undefined;
  }
  if (isOurs && field.oneof === undefined && isEmpty(member)) return undefined;
  return writeValue(field.type, member);
}

function writeValue(type: FieldDescriptor['type'], value: unknown): JsonValue {
  if (typeof type === 'object') {
    if (type.kind === 'message') return writeMessage(type, value as object);
    return type.nameByNumber.get(Number(value)) ?? Number(value);
  }
  switch (type) {
    case 'double':
    case 'float':
      return writeFloat(Number(value));
    case 'int32':
      return Number(value);
    case 'int64':
      return writeInt64(Number(value));
    case 'bool':
      return Boolean(value);
    case 'string':
      return String(value);
    case 'bytes':
      return formatBase64(value as Uint8Array);
  }
}

/** JSON has no words for these three; proto3 writes them as text. */
function writeFloat(value: number): number | string {
  return Number.isFinite(value) ? value : String(value);
}

/** Without an exponent, also beyond 2^53. */
function writeInt64(value: number): string {
  return Number.isFinite(value) ? BigInt(Math.trunc(value)).toString() : '0';
}

function defaultOf(type: FieldDescriptor['type']): JsonValue {
  if (typeof type === 'object') {
    return type.kind === 'enum' ? (type.nameByNumber.get(0) ?? 0) : {};
  }
  if (type === 'bool') return false;
  if (type === 'int64') return '0';
  return type === 'string' || type === 'bytes' ? '' : 0;
}

function isMessageField({ type }: FieldDescriptor): boolean {
  return typeof type === 'object' && type.kind === 'message';
}

function isEmpty(value: unknown): boolean {
  return value === 0 || value === '' || value === false;
}
