import { constantRecord } from '@ubii/pm-sandbox';
import { DATA_FORMATS, isMessageType, parseDataFormat, toJson, type JsonValue } from '@ubii/proto';
import { defaultText } from '../../formats/default-text.ts';
import { fieldKind, isTypable, valueOf } from '../../formats/value-parts.ts';
import type { IoDraft } from './module-draft.ts';

/** One record member as `defaultFromText` writes it, complete or not. */
const MEMBER = /^\{"\w+":([\s\S]*)\}$/;

/** Neutral value of a data format as JSON. */
export function neutralJson(formatText: string): JsonValue {
  const format = parseDataFormat(formatText) ?? 'double';
  const { messageType, createDefault } = DATA_FORMATS[format];
  const value = createDefault();
  return isMessageType(messageType) ? toJson(messageType, value as never) : (value as JsonValue);
}

/** Whether the form has a field for the default of an input. Also true for a default that does not fit: it can be removed. */
export function takesDefault({ format, isList, defaultJson }: IoDraft): boolean {
  const known = parseDataFormat(format);
  return defaultJson !== undefined || (!isList && known !== undefined && isTypable(known));
}

/** Returns the default of an input as text: `1` for `{"double":1}`. */
export function textOfDefault({ format, defaultJson }: IoDraft): string {
  if (defaultJson === undefined) return '';
  const isText =
    parseDataFormat(format) === 'string' && valueOf('string', defaultJson) !== undefined;
  const member = isText ? undefined : MEMBER.exec(defaultJson)?.[1];
  return member ?? defaultText(defaultJson) ?? defaultJson;
}

/** Returns the JSON of a default as typed, which may be invalid; `undefined` for an empty text. */
export function defaultFromText(text: string, formatText: string): string | undefined {
  if (text.trim() === '') return undefined;
  const format = parseDataFormat(formatText);
  if (format === undefined) return text;
  return format === 'string' ? JSON.stringify({ string: text }) : `{"${format}":${text}}`;
}

/** Returns what is wrong with the default of an input. */
export function defaultProblem({ format, isList, defaultJson }: IoDraft): string | undefined {
  if (defaultJson === undefined) return undefined;
  if (isList) return 'Only an input for one record has a default. Remove the default.';
  const known = parseDataFormat(format);
  if (!('problem' in constantRecord(defaultJson, known))) return undefined;
  if (known === undefined) return 'Enter one record as JSON, such as {"double":1}.';
  switch (fieldKind(known)) {
    case 'number':
      return 'Enter a number, such as 1.';
    case 'switch':
      return 'Enter true or false.';
    default:
      return `Enter a ${known} as JSON, such as ${JSON.stringify(neutralJson(known))}.`;
  }
}

/** Returns the value of a valid default, with all its members; without one, the neutral value. */
export function initialJson(io: IoDraft): JsonValue {
  const neutral = neutralJson(io.format);
  const format = parseDataFormat(io.format);
  if (io.defaultJson === undefined || format === undefined || defaultProblem(io)) return neutral;
  const value = valueOf(format, io.defaultJson) as JsonValue;
  return isObject(value) && isObject(neutral) ? { ...neutral, ...value } : value;
}

const isObject = (value: JsonValue): value is { [name: string]: JsonValue } =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
