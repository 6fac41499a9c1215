import { decodeRecord, encodeRecord } from '@ubii/proto';
import type { DataFormat } from '@ubii/proto';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { parseField } from '../mapping/field-path.ts';
import type { PayloadKind } from '../mapping/mapping.ts';
import { mappingOf } from '../../testing/mapping-of.ts';
import { bytesCodec } from './bytes-codec.ts';

const bytes = (text: string): Uint8Array => new TextEncoder().encode(text);
const text = (payload: Uint8Array): string => new TextDecoder().decode(payload);

function mapping(payload: PayloadKind, format: DataFormat | undefined, field = '') {
  return mappingOf('both', 'a', '/a', { payload, format, field: parseField(field) });
}
const read = (payload: PayloadKind, format: DataFormat, message: string, field = '') =>
  bytesCodec.read(bytes(message), mapping(payload, format, field)).value;
const write = (payload: PayloadKind, format: DataFormat, value: unknown, field = '') =>
  text(
    bytesCodec.write(
      { topic: '/a', format, value, bytes: new Uint8Array() },
      mapping(payload, format, field),
    ),
  );

describe('messages that are bytes [BR-10] [BR-11]', () => {
  it.each([
    ['json', 'double', '21.5', '', 21.5],
    ['json', 'double', '"21.5"', '', 21.5],
    ['json', 'double', '{"t":[{"c":3}]}', 't[0].c', 3],
    ['json', 'bool', '"ON"', '', true],
    ['json', 'bool', '0', '', false],
    ['json', 'string', '{"a":1}', '', '{"a":1}'],
    ['json', 'int32', '7', '', 7],
    ['json', 'vector2', '{"x":1,"y":2}', '', { x: 1, y: 2 }],
    ['text', 'string', 'häll', '', 'häll'],
    ['text', 'bool', 'off', '', false],
    ['number', 'double', ' 1e3 ', '', 1000],
    ['number', 'bool', '2', '', true],
  ] as const)('reads %s as %s: %s %s', (payload, format, message, field, expected) => {
    expect(read(payload, format, message, field)).toEqual(expected);
  });

  it.each([
    ['json', 'double', 'x', '', 'is not JSON'],
    ['json', 'double', '{"t":1}', 'u', 'has no such field'],
    ['json', 'double', '"warm"', '', 'Expected a number, got "warm".'],
    ['json', 'double', 'true', '', 'Expected a number, got true.'],
    ['json', 'double', '1e999', '', 'Expected a number, got null.'],
    ['json', 'int32', '1.5', '', 'Expected a whole number'],
    ['json', 'vector2', '[1,2]', '', 'Expected an object with the members of vector2'],
    ['json', 'vector2', '{"x":"a"}', '', 'x'],
    ['json', 'double', '['.repeat(40), '', 'has more than 32 levels'],
    ['number', 'double', '', '', 'Expected a number'],
    ['bytes', 'image2D', 'no picture', '', 'image2D.data must be 0 bytes'],
  ] as const)('refuses %s as %s: %s %s', (payload, format, message, field, reason) => {
    expect(() => read(payload, format, message, field)).toThrow(reason);
  });

  it.each([
    ['json', 'double', 21.5, '', '21.5'],
    ['json', 'double', 3, 'values[1].celsius', '{"values":[null,{"celsius":3}]}'],
    ['json', 'vector2', { x: 1, y: 2 }, 'position', '{"position":{"x":1,"y":2}}'],
    ['text', 'bool', true, '', 'true'],
    ['text', 'string', 'a "quoted" word', '', 'a "quoted" word'],
    ['number', 'bool', true, '', '1'],
    ['event', 'keyEvent', { type: 1, key: 'a' }, '', '{"event_type":"press"}'],
    ['event', 'touchEvent', { type: 2 }, '', '{"event_type":"release"}'],
  ] as const)('writes %s of %s: %j', (payload, format, value, field, expected) => {
    expect(write(payload, format, value, field)).toBe(expected);
  });

  it('does not write numbers that JSON has not, and moves of a finger as events', () => {
    expect(() => write('json', 'double', Number.NaN)).toThrow('cannot be written');
    expect(() => write('event', 'touchEvent', { type: 1 })).toThrow('no event of a button');
  });

  it('reads what is not text as no text', () => {
    expect(() => bytesCodec.read(Uint8Array.of(0xff, 0xfe), mapping('text', 'string'))).toThrow(
      'not text in UTF-8',
    );
  });

  it('carries a file of a picture, and numbers from 0 to 255, as bytes', () => {
    const jpeg = Uint8Array.of(0xff, 0xd8, 0xff, 0xe0, 1);
    const { value } = bytesCodec.read(jpeg, mapping('bytes', 'image2D'));
    expect(value).toMatchObject({ data: jpeg });
    const list = { elements: [0, 255] };
    expect(bytesCodec.read(Uint8Array.of(0, 255), mapping('bytes', 'int32List')).value).toEqual(
      list,
    );
    expect(() => write('bytes', 'int32List', { elements: [256] })).toThrow('is not a byte');
  });

  it('carries a record as it is', () => {
    const record = encodeRecord({
      topic: '/b',
      format: 'vector2',
      value: { x: 1, y: 2 },
      timestampMs: 1_700_000_000_000,
    });
    const carried = bytesCodec.write(
      { topic: '/b', format: 'vector2', value: undefined, bytes: record },
      mapping('protobuf', undefined),
    );
    expect(decodeRecord(carried).topic).toBe('/b');
    expect(bytesCodec.read(carried, mapping('protobuf', undefined))).toEqual({
      format: 'vector2',
      value: { x: 1, y: 2 },
      timestampMs: 1_700_000_000_000,
    });
    expect(() => bytesCodec.read(record, mapping('protobuf', 'double'))).toThrow(
      'Expected a record of double, got one of vector2',
    );
    expect(() => bytesCodec.read(bytes('no record'), mapping('protobuf', undefined))).toThrow();
  });

  it('reads numbers and texts that it wrote', () => {
    fc.assert(
      fc.property(
        fc.double({ noNaN: true, noDefaultInfinity: true }),
        fc.string({ unit: 'grapheme' }),
        (number, word) => {
          expect(read('json', 'double', write('json', 'double', number))).toBe(number + 0 || 0);
          expect(read('text', 'string', write('text', 'string', word))).toBe(word);
        },
      ),
    );
  });

  it('throws nothing but an Error with a sentence for whatever comes', () => {
    const kinds = fc.constantFrom<PayloadKind>('json', 'text', 'number', 'bytes', 'protobuf');
    const formats = fc.constantFrom<DataFormat>('double', 'bool', 'string', 'vector3', 'image2D');
    fc.assert(
      fc.property(kinds, formats, fc.uint8Array({ maxLength: 64 }), (kind, format, message) => {
        try {
          bytesCodec.read(message, mapping(kind, format));
        } catch (error) {
          expect((error as Error).message).toMatch(/\S/);
        }
      }),
    );
  });
});
