import {
  DATA_FORMATS,
  isMessageType,
  toJson,
  type FieldDescriptor,
  type JsonObject,
  type JsonValue,
  type MessageDescriptor,
} from '@ubii/proto';

/** A value to begin with, as JSON: what the data format's neutral value is, else zeros and nothing. */
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

/** The object a JSON value is; an empty one for anything else. */
export function asObject(json: JsonValue | undefined): JsonObject {
  return typeof json === 'object' && json !== null && !Array.isArray(json) ? json : {};
}

/** The number a JSON value says; 0 for anything else. */
export function asNumber(json: JsonValue | undefined): number {
  const number = typeof json === 'string' && json.trim() === '' ? 0 : Number(json ?? 0);
  return Number.isFinite(number) ? number : 0;
}
