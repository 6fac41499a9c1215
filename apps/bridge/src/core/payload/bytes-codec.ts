import { DATA_FORMATS, decodeRecord } from '@ubii/proto';
import type { DataFormat, Image2D } from '@ubii/proto';
import { readField, writeField } from '../mapping/field-path.ts';
import type { Mapping } from '../mapping/mapping.ts';
import { eventOf } from './button-events.ts';
import { parseBoundedJson, readText } from './parse-bounded-json.ts';
import type { OutgoingRecord, PayloadCodec, TypedValue } from './payload-codec.ts';
import { fromValue, toValue } from './plain-values.ts';

const encoder = new TextEncoder();

/** Messages that are bytes, as those of MQTT: JSON, text, numbers, bytes and records. [BR-10] */
export const bytesCodec: PayloadCodec<Uint8Array> = {
  read(payload, mapping) {
    switch (mapping.payload) {
      case 'json':
        return valueOf(mapping, findField(parseBoundedJson(payload), mapping));
      case 'text':
        return valueOf(mapping, readText(payload));
      case 'number':
        return valueOf(mapping, readNumber(readText(payload), mapping));
      case 'bytes':
        return { format: formatOf(mapping), value: readBytes(payload, formatOf(mapping)) };
      case 'protobuf':
        return readRecord(payload, mapping);
      case 'event':
        throw new Error('Events are only sent.');
    }
  },
  write(record, mapping) {
    const { format, value, bytes } = record;
    switch (mapping.payload) {
      case 'json': {
        const json = writeField(fromValue(format, value), mapping.field);
        return encoder.encode(JSON.stringify(json));
      }
      case 'text':
        return encoder.encode(String(fromValue(format, value)));
      case 'number':
        return encoder.encode(String(Number(fromValue(format, value))));
      case 'bytes':
        return writeBytes(record);
      case 'protobuf':
        return bytes;
      case 'event':
        return encoder.encode(JSON.stringify({ event_type: eventOf(record) }));
    }
  },
};

function valueOf(mapping: Mapping, json: unknown): TypedValue {
  const format = formatOf(mapping);
  return { format, value: toValue(format, json) };
}

function formatOf({ format }: Mapping): DataFormat {
  if (format === undefined) throw new Error('The mapping has no data format.');
  return format;
}

function findField(json: unknown, { field }: Mapping): unknown {
  const found = readField(json, field);
  if (found === undefined) throw new Error('The message has no such field.');
  return found;
}

function readNumber(text: string, { format }: Mapping): unknown {
  const number = toValue('double', text);
  return format === 'bool' ? number !== 0 : number;
}

function readRecord(payload: Uint8Array, mapping: Mapping): TypedValue {
  // A copy: the value of a picture is a view of the message.
  const { format, value, timestampMs } = decodeRecord(payload.slice());
  if (format === undefined) throw new Error('The record has no value.');
  if (mapping.format !== undefined && mapping.format !== format) {
    throw new Error(`Expected a record of ${mapping.format}, got one of ${format}.`);
  }
  return { format, value, timestampMs };
}

/** Bytes are the file of a picture, or a list of numbers. */
function readBytes(payload: Uint8Array, format: DataFormat): unknown {
  const value =
    format === 'image2D'
      ? { width: 0, height: 0, dataFormat: 0, data: payload.slice() }
      : { elements: [...payload] };
  const problem = DATA_FORMATS[format].validate(value);
  if (problem !== undefined) throw new Error(problem);
  return value;
}

function writeBytes({ format, value }: OutgoingRecord): Uint8Array {
  if (format === 'image2D') return (value as Image2D).data;
  const { elements } = value as { readonly elements: readonly number[] };
  if (elements.every((element) => element >= 0 && element <= 255)) return Uint8Array.from(elements);
  throw new Error('An element is not a byte: use numbers from 0 to 255.');
}
