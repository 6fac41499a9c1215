import { DATA_FORMATS, isMessageType, toJson, type JsonValue, type TopicRecord } from '@ubii/proto';
import { formatBytes } from '../../ui/readouts/format-bytes.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';

/** Longest text that is parsed as JSON, characters. */
const MAX_PARSED = 1_000_000;

/** Converts a value to the JSON form of the protocol, with pictures in base64. */
export function valueJson({ format, value }: TopicRecord): JsonValue {
  const { messageType } = DATA_FORMATS[format];
  return isMessageType(messageType) ? toJson(messageType, value as never) : (value as JsonValue);
}

/** Converts a value to JSON for display: bytes as their number, texts with JSON parsed. */
export function readableJson(record: TopicRecord): JsonValue {
  const { format, value } = record;
  if (format === 'string') return parsed(value);
  if (format === 'image2D') return withoutBytes(value);
  if (format === 'image2DList') return { elements: value.elements.map(withoutBytes) };
  return valueJson(record);
}

function parsed(text: string): JsonValue {
  if (!/^\s*[[{]/.test(text) || text.length > MAX_PARSED) return text;
  try {
    return JSON.parse(text) as JsonValue;
  } catch {
    return text; // Starts like JSON, but is not.
  }
}

function withoutBytes(image: { readonly data: Uint8Array }): JsonValue {
  const { digits, unit } = formatBytes(image.data.length);
  const json = toJson('ubii.dataStructure.Image2D', { ...image, data: new Uint8Array(0) });
  const exact = `${formatNumber(image.data.length)} bytes`;
  return { ...json, data: image.data.length < 1000 ? exact : `${exact} (${digits} ${unit ?? ''})` };
}
