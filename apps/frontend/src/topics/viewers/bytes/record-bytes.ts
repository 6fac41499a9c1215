import { encodeRecord, type TopicRecord } from '@ubii/proto';

/** A part of a record that is looked at byte by byte. */
export interface ByteSource {
  readonly id: string;
  readonly text: string;
  readonly bytes: () => Uint8Array;
}

/** The bytes within a value, and the whole record as this program encodes it. */
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
