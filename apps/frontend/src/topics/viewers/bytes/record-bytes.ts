import { encodeRecord, type TopicRecord } from '@ubii/proto';

/** Part of a record whose bytes can be shown. */
export interface ByteSource {
  readonly id: string;
  readonly text: string;
  readonly bytes: () => Uint8Array;
}

/** Returns the byte arrays in a value, and the whole record as encoded by this program. */
export function byteSources(record: TopicRecord): readonly ByteSource[] {
  const { format, value } = record;
  const whole = { id: 'record', text: 'Record', bytes: () => encodeRecord(record) };
  if (format === 'image2D') return [{ id: 'data', text: 'data', bytes: () => value.data }, whole];
  if (format === 'image2DList') {
    const pictures = value.elements.slice(0, 2).map(({ data }, index) => ({
      id: `data${index}`,
      text: `data ${index}`,
      bytes: () => data,
    }));
    return [...pictures, whole];
  }
  if (format === 'string') {
    const text = { id: 'text', text: 'Text', bytes: () => new TextEncoder().encode(value) };
    return [whole, text];
  }
  return [whole];
}
