import type { MessageType } from '../codec.ts';
import { MAX_NESTED_MESSAGES } from '../binary/max-nested-messages.ts';
import { DecodeError } from '../decode-error.ts';
import {
  messageDescriptor,
  type EnumDescriptor,
  type FieldDescriptor,
  type MessageDescriptor,
} from '../descriptor.ts';
import type { MessageTypes } from '../generated/messages.ts';
import { parseBase64 } from './base64.ts';
import { withoutLegacyMapping, similarName } from './member-names.ts';

const MIN_INT32 = -(2 ** 31);
const MAX_INT32 = 2 ** 31 - 1;

/**
 * Reads a message from JSON leniently: camelCase and snake_case keys, enums by name or number,
 * numbers as text, base64 and base64url. `null` members and elements and unknown keys are dropped.
 * The result has the shape `decode` gives. [SV-3]
 *
 * Reads along the schema, which does not contain itself: nesting that the schema does not have is
 * an unknown key and never looked into.
 *
 * @param json what `JSON.parse` returned
 * @throws DecodeError that names the member
 */
export function fromJson<T extends MessageType>(type: T, json: unknown): MessageTypes[T] {
  const context = { type, messagesLeft: MAX_NESTED_MESSAGES };
  return readMessage(messageDescriptor(type), json, '', context) as MessageTypes[T];
}

/** One thing that is wrong with a message written as JSON. */
export interface JsonProblem {
  /** Where: `position.x`, `elements[2].id`; empty for the message itself. */
  readonly path: string;
  /** What, to be read after the path: `must be a number, got "a"`. */
  readonly sentence: string;
}

/**
 * Everything that is wrong with a message written as JSON, for people who write it: what `fromJson`
 * refuses, and what it passes over: members the message does not have, and two members of which only
 * one can be.
 *
 * @param json what `JSON.parse` returned
 */
export function findJsonProblems(type: MessageType, json: unknown): JsonProblem[] {
  const problems: JsonProblem[] = [];
  const context = { type, messagesLeft: MAX_NESTED_MESSAGES, problems };
  try {
    readMessage(messageDescriptor(type), json, '', context);
  } catch (error) {
    problems.push({ path: '', sentence: DecodeError.wrap(type, 0, error).message });
  }
  return problems;
}

interface Context {
  /** The message that is read, for errors. */
  readonly type: string;
  /** As the binary reader counts them. */
  messagesLeft: number;
  /** When all are looked for; else the first one is thrown. */
  readonly problems?: JsonProblem[];
}

function fail(context: Context, path: string, expected: string, received: unknown): never {
  const sentence = `must be ${expected}, got ${describe(received)}`;
  if (context.problems) {
    context.problems.push({ path, sentence });
    // Nothing of what is read is used then.
    return undefined as never;
  }
  throw new DecodeError(context.type, 0, `${path === '' ? 'it' : path} ${sentence}`);
}

function readMessage(
  type: MessageDescriptor,
  json: unknown,
  path: string,
  context: Context,
): object {
  if (typeof json !== 'object' || json === null || Array.isArray(json)) {
    return fail(context, path, 'an object', json);
  }
  if (--context.messagesLeft < 0) {
    throw new DecodeError(context.type, 0, `more than ${MAX_NESTED_MESSAGES} messages within one`);
  }
  const message = emptyMessage(type);
  const chosen = new Map<string, string>();
  for (const [key, value] of Object.entries(withoutLegacyMapping(type.name, json as object))) {
    const field = type.fieldByName.get(key);
    const memberPath = path === '' ? key : `${path}.${key}`;
    // Only for those who look for it: a list of the members costs more than the rest.
    if (field === undefined && context.problems !== undefined) {
      context.problems.push({ path: memberPath, sentence: unknownMember(type, key) });
    }
    if (field === undefined || value === null || value === undefined) continue;
    if (field.repeated) {
      message[field.jsonName] = readList(field, value, memberPath, context);
      continue;
    }
    message[field.jsonName] = readValue(field.type, value, memberPath, context);
    if (field.oneof === undefined) continue;
    const other = chosen.get(field.oneof);
    if (other !== undefined && other !== field.jsonName) {
      delete message[other];
      context.problems?.push({ path: memberPath, sentence: `cannot stand beside ${other}` });
    }
    chosen.set(field.oneof, field.jsonName);
  }
  return message;
}

/** Members named for a key that resembles none. */
const MAX_NAMED_MEMBERS = 5;

function unknownMember({ fields }: MessageDescriptor, key: string): string {
  const names = fields.map(({ jsonName }) => jsonName);
  const meant = similarName(key, names);
  if (meant !== undefined) return `is not known here. Did you mean ${meant}?`;
  const more = names.length - MAX_NAMED_MEMBERS;
  const named = names.slice(0, MAX_NAMED_MEMBERS).join(', ');
  return `is not known here; there are ${named}${more > 0 ? ` and ${more} more` : ''}`;
}

/** A message as `decode` returns it for no bytes. */
function emptyMessage(type: MessageDescriptor): Record<string, unknown> {
  const message: Record<string, unknown> = {};
  for (const field of type.fields) {
    if (field.oneof === undefined) message[field.jsonName] = defaultOf(field);
  }
  return message;
}

function defaultOf({ repeated, type }: FieldDescriptor): unknown {
  if (repeated) return [];
  if (typeof type === 'object') return type.kind === 'enum' ? 0 : undefined;
  if (type === 'string') return '';
  if (type === 'bool') return false;
  return type === 'bytes' ? new Uint8Array(0) : 0;
}

function readList(
  field: FieldDescriptor,
  json: unknown,
  path: string,
  context: Context,
): unknown[] {
  if (!Array.isArray(json)) return fail(context, path, 'a list', json);
  const list: unknown[] = [];
  (json as unknown[]).forEach((element, i) => {
    if (element === null || element === undefined) return;
    list.push(readValue(field.type, element, `${path}[${i}]`, context));
  });
  return list;
}

function readValue(
  type: FieldDescriptor['type'],
  json: unknown,
  path: string,
  context: Context,
): unknown {
  if (typeof type === 'object') {
    return type.kind === 'enum'
      ? readEnum(type, json, path, context)
      : readMessage(type, json, path, context);
  }
  switch (type) {
    case 'double':
    case 'float':
      return readNumber(json, path, context);
    case 'int32':
    case 'int64':
      return readInteger(type, json, path, context);
    case 'bool':
      if (json === true || json === 'true' || json === 1) return true;
      if (json === false || json === 'false' || json === 0) return false;
      return fail(context, path, 'true or false', json);
    case 'string':
      return typeof json === 'string' ? json : readTextFrom(json, path, context);
    case 'bytes':
      return readBytes(json, path, context);
  }
}

/** Ids and ports that clients send as numbers. */
function readTextFrom(json: unknown, path: string, context: Context): string {
  return typeof json === 'number' || typeof json === 'boolean'
    ? String(json)
    : fail(context, path, 'text', json);
}

function readNumber(json: unknown, path: string, context: Context): number {
  if (typeof json === 'number') return json;
  if (json === 'NaN') return NaN;
  const number = typeof json === 'string' && json.trim() !== '' ? Number(json) : NaN;
  return Number.isNaN(number) ? fail(context, path, 'a number', json) : number;
}

function readInteger(
  type: 'int32' | 'int64',
  json: unknown,
  path: string,
  context: Context,
): number {
  const number = readNumber(json, path, context);
  const isInRange =
    type === 'int32' ? number >= MIN_INT32 && number <= MAX_INT32 : Math.abs(number) <= 2 ** 63;
  return Number.isInteger(number) && isInRange
    ? number
    : fail(context, path, `an integer of ${type === 'int32' ? 32 : 64} bits`, json);
}

function readEnum(type: EnumDescriptor, json: unknown, path: string, context: Context): number {
  const number = typeof json === 'string' ? type.numberByName.get(json) : undefined;
  if (number !== undefined) return number;
  const isNumeric = typeof json === 'number' || (typeof json === 'string' && /^-?\d+$/.test(json));
  return isNumeric
    ? readInteger('int32', json, path, context)
    : fail(context, path, `one of ${[...type.numberByName.keys()].join(', ')}`, json);
}

function readBytes(json: unknown, path: string, context: Context): Uint8Array {
  const bytes = typeof json === 'string' ? parseBase64(json) : undefined;
  return bytes ?? fail(context, path, 'base64 text', json);
}

function describe(value: unknown): string {
  if (value === null) return 'null';
  if (Array.isArray(value)) return `a list of ${value.length}`;
  if (typeof value === 'object') return 'an object';
  if (typeof value !== 'string') return String(value);
  return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}…` : value);
}
