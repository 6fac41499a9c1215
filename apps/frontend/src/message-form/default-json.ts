import {
  DATA_FORMATS,
  isMessageType,
  toJson,
  type FieldDescriptor,
  type JsonObject,
  type JsonValue,
  type MessageDescriptor,
} from '@ubii/proto';

/** Returns the initial value as JSON: the neutral value of a data format, otherwise zeros and empty values. */
export function defaultJson(type: FieldDescriptor['type']): JsonValue {
  if (typeof type === 'object') {
    return type.kind === 'enum' ? (type.nameByNumber.get(0) ?? 0) : defaultMessage(type);
  }
  if (type === 'bool') return false;
  if (type === 'int64') return '0';
  return type === 'string' || type === 'bytes' ? '' : 0;
}

function defaultMessage({ name }: MessageDescriptor): JsonObject {
  const info = Object.values(DATA_FORMATS).find(({ messageType }) => messageType === name);
  if (!isMessageType(name)) return {};
  return toJson(name, (info?.createDefault() ?? {}) as never);
}

/** Returns a JSON value that is an object; an empty one for other values. */
export function asObject(json: JsonValue | undefined): JsonObject {
  return typeof json === 'object' && json !== null && !Array.isArray(json) ? json : {};
}

/** Returns a JSON value that is a number; 0 for other values. */
export function asNumber(json: JsonValue | undefined): number {
  const number = typeof json === 'string' && json.trim() === '' ? 0 : Number(json ?? 0);
  return Number.isFinite(number) ? number : 0;
}
