import { decodeRecord, Image2DDataFormat } from '@ubii/proto';
import { expect, it } from 'vitest';
import { afterKey, asNumbers, hexRow, hexText, selected } from './hex-rows.ts';
import { byteSources } from './record-bytes.ts';

const bytes = Uint8Array.from({ length: 40 }, (_none, index) => index * 3);

it('a row says where it is, its bytes and its letters', () => {
  expect(hexRow(bytes, 1, 16)).toMatchObject({ offset: 16, address: '00000010' });
  expect(hexRow(bytes, 2, 16).hex).toHaveLength(8);
  expect(hexRow(new Uint8Array([0x41, 0x00, 0xff]), 0, 16)).toMatchObject({
    hex: ['41', '00', 'ff'],
    text: ['A', '·', '·'],
  });
});

it('a selection goes in both directions, and keys stay within', () => {
  expect(selected(bytes, { anchor: 5, end: 3 })).toMatchObject({ from: 3 });
  expect(hexText(selected(bytes, { anchor: 5, end: 3 }).bytes)).toBe('09 0c 0f');
  expect(afterKey('ArrowDown', 0, 16, 40)).toBe(16);
  expect(afterKey('ArrowDown', 30, 16, 40)).toBe(30);
  expect(afterKey('PageDown', 0, 16, 40)).toBe(39);
  expect(afterKey('a', 0, 16, 40)).toBeUndefined();
});

it('four bytes are read as numbers', () => {
  const float = new Uint8Array(new Float32Array([1.5]).buffer);
  expect(asNumbers(float)).toContainEqual({ name: 'float', text: '1.5' });
});

it('a record is encoded as it travels, and a picture shows its own bytes first', () => {
  const record = {
    topic: '/a',
    format: 'double',
    value: 2,
    clientId: 'c',
    timestampMs: 5,
  } as const;
  expect(decodeRecord(byteSources(record)[0]!.bytes())).toMatchObject({ topic: '/a', value: 2 });
  const image = {
    width: 1,
    height: 1,
    dataFormat: Image2DDataFormat.GRAY8,
    data: new Uint8Array([7]),
  };
  const [data] = byteSources({ ...record, format: 'image2D', value: image });
  expect(data?.bytes()).toEqual(image.data);
});
