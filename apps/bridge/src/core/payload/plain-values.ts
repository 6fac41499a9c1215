import { DATA_FORMATS, fromJson, toJson } from '@ubii/proto';
import type { DataFormat, Init, MessageType, MessageTypes } from '@ubii/proto';

const NUMBER = /^\s*[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?\s*$/i;
/** No number needs more characters. */
const NUMBER_CHARACTERS = 64;
const TRUE: readonly unknown[] = [true, 1, 'true', 'on', '1', 'yes', 'open'];
const FALSE: readonly unknown[] = [false, 0, 'false', 'off', '0', 'no', 'closed'];

/**
 * Makes a value of a topic of what JSON, or a message of another system, has: numbers also as text, truth values also as
 * on and off, messages by the names of their members. [BR-11]
 *
 * @throws Error with what was expected
 */
export function toValue(format: DataFormat, json: unknown): unknown {
  const value = convert(format, json);
  const problem = DATA_FORMATS[format].validate(value);
  if (problem !== undefined) throw new Error(problem);
  return value;
}

function convert(format: DataFormat, json: unknown): unknown {
  switch (format) {
    case 'double':
    case 'float':
      return toNumber(json);
    case 'int32': {
      const number = toNumber(json);
      if (number === (number | 0)) return number;
      throw new Error(`Expected a whole number from -2^31 to 2^31 - 1, got ${shown(json)}.`);
    }
    case 'bool': {
      const word = typeof json === 'string' ? json.trim().toLowerCase() : json;
      if (TRUE.includes(word)) return true;
      if (FALSE.includes(word)) return false;
      throw new Error(`Expected true or false, got ${shown(json)}.`);
    }
    case 'string':
      if (json === undefined) throw new Error('Expected a text, got nothing.');
      return typeof json === 'string' ? json : JSON.stringify(json);
    default:
      if (typeof json !== 'object' || json === null || Array.isArray(json)) {
        throw new Error(`Expected an object with the members of ${format}, got ${shown(json)}.`);
      }
      return fromJson(messageTypeOf(format), json);
  }
}

function toNumber(json: unknown): number {
  if (typeof json === 'number' && Number.isFinite(json)) return json;
  if (typeof json === 'string' && json.length <= NUMBER_CHARACTERS && NUMBER.test(json))
    return Number(json);
  throw new Error(`Expected a number, got ${shown(json)}.`);
}

/**
 * Returns what JSON has for a value of a topic.
 *
 * @throws Error for a number that JSON has not
 */
export function fromValue(format: DataFormat, value: unknown): unknown {
  if (typeof value === 'number' && !Number.isFinite(value)) {
    throw new Error(`The number ${value} cannot be written.`);
  }
  if (typeof value !== 'object' || value === null) return value;
  const type = messageTypeOf(format);
  return toJson(type, value as Init<MessageTypes[typeof type]>);
}

function messageTypeOf(format: DataFormat): MessageType {
  return DATA_FORMATS[format].messageType as MessageType;
}

/** Returns a short text of anything, for messages and previews. */
export function shown(value: unknown, maxChars = 60): string {
  if (value instanceof Uint8Array) return `${value.byteLength} bytes`;
  let text: string;
  try {
    text = JSON.stringify(value, (_key, member: unknown) =>
      member instanceof Uint8Array ? `${member.byteLength} bytes` : member,
    );
  } catch {
    text = String(value);
  }
  if (text === undefined) return 'nothing';
  return text.length > maxChars ? `${text.slice(0, maxChars - 1)}…` : text;
}
