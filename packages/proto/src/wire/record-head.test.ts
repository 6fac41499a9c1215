import { expect, it } from 'vitest';
import { TextCache } from '../binary/text-cache.ts';
import { DATA_FORMATS } from '../data-formats/data-formats.ts';
import { DecodeError } from '../decode-error.ts';
import { encodeRecord } from '../records.ts';
import { readRecordHead } from './record-head.ts';

const value = { data: new Uint8Array(5_000), width: 50, height: 100, dataFormat: 0 } as const;

it('reads topic, value field and publisher of an encoded record', () => {
  const record = encodeRecord({ topic: '/ä', format: 'image2D', value, clientId: 'ada' });
  for (const texts of [undefined, new TextCache()]) {
    expect(readRecordHead(record, texts)).toEqual({
      topic: '/ä',
      valueField: DATA_FORMATS.image2D.fieldNumber,
      clientId: 'ada',
      keepSeconds: 0,
      expiryMs: 0,
    });
  }
  expect(readRecordHead(encodeRecord({ topic: '/gone' }))).toEqual({
    topic: '/gone',
    valueField: 0,
    clientId: '',
    keepSeconds: 0,
    expiryMs: 0,
  });
});

it('reads how long a value outlives its publisher [TD-43]', () => {
  const record = encodeRecord({ topic: '/t', format: 'double', value: 1, keepSeconds: 600 });
  expect(readRecordHead(record).keepSeconds).toBe(600);
});

it('reads how long a value stands, with and without a value [TD-47]', () => {
  const picture = encodeRecord({ topic: '/t', format: 'image2D', value, expiryMs: 1500 });
  expect(readRecordHead(picture)).toMatchObject({ expiryMs: 1500, keepSeconds: 0 });
  expect(readRecordHead(encodeRecord({ topic: '/t', expiryMs: 1 })).expiryMs).toBe(1);
  const both = encodeRecord({
    topic: '/t',
    format: 'double',
    value: 1,
    keepSeconds: 5,
    expiryMs: 7,
  });
  expect(readRecordHead(both)).toMatchObject({ keepSeconds: 5, expiryMs: 7 });
});

it('fails as a DecodeError when the record is cut off', () => {
  const record = encodeRecord({ topic: '/t', format: 'image2D', value });
  expect(() => readRecordHead(record.subarray(0, 100))).toThrow(DecodeError);
});
