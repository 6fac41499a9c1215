import { DATA_FORMATS, type DataFormat, type TopicRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import { jsonRows } from './json-rows.ts';
import { readableJson, valueJson } from './value-json.ts';

const record = (format: DataFormat, value: unknown): TopicRecord =>
  ({ topic: '/a', format, value, timestampMs: undefined, clientId: '' }) as TopicRecord;

describe('valueJson', () => {
  it('writes every data format so that it can be pasted elsewhere', () => {
    for (const { format, createDefault } of Object.values(DATA_FORMATS)) {
      const text = JSON.stringify(valueJson(record(format, createDefault())));
      expect(text, format).toBeTypeOf('string');
    }
    expect(valueJson(record('double', 1.5))).toBe(1.5);
    expect(valueJson(record('vector2', { x: 1, y: 2 }))).toEqual({ x: 1, y: 2 });
  });
});

describe('readableJson', () => {
  it('reads texts that are JSON, and leaves others alone', () => {
    expect(readableJson(record('string', '{"stage":"2m"}'))).toEqual({ stage: '2m' });
    expect(readableJson(record('string', '{not json'))).toBe('{not json');
    expect(readableJson(record('string', '12'))).toBe('12');
  });

  it('counts the bytes of pictures instead of writing them', () => {
    const image = { width: 2, height: 1, dataFormat: 1, data: new Uint8Array(38_412) };
    expect(readableJson(record('image2D', image))).toEqual({
      width: 2,
      height: 1,
      dataFormat: 'RGB8',
      data: `${formatNumber(38_412)} bytes (38 kB)`,
    });
    expect(readableJson(record('image2DList', { elements: [image] }))).toMatchObject({
      elements: [{ data: `${formatNumber(38_412)} bytes (38 kB)` }],
    });
  });
});

describe('jsonRows', () => {
  const lines = (value: never, open = true) =>
    jsonRows(value, () => open).map(({ level, name, text }) => `${level} ${name} ${text}`);

  it('writes members at the left edge and what is in them below', () => {
    expect(lines({ x: -1, list: [true, null], name: 'a' } as never)).toEqual([
      '1 x −1',
      '1 list [2]',
      '2 0 true',
      '2 1 null',
      '1 name "a"',
    ]);
  });

  it('says what a closed branch holds', () => {
    expect(lines({ pose: { x: 1, y: 2 }, none: [], empty: {} } as never, false)).toEqual([
      '1 pose {x, y}',
      '1 none []',
      '1 empty {}',
    ]);
  });

  it('writes single precision with the digits it has', () => {
    expect(lines(Math.fround(0.4) as never)).toEqual(['1  0.4']);
    expect(lines(0.7998723649947398 as never)).toEqual(['1  0.7998723649947398']);
    expect(lines(-1e-9 as never)).toEqual(['1  −1e−9']);
  });

  it('writes a value that is not in another', () => {
    expect(lines(4.5 as never)).toEqual(['1  4.5']);
    expect(lines([] as never)).toEqual(['1  []']);
  });

  it('stays bounded and says what is left out', () => {
    const wide = jsonRows(Array.from({ length: 5000 }, (_, i) => i) as never, () => true);
    expect(wide).toHaveLength(101);
    expect(wide.at(-1)?.text).toBe('4900 more');
    const matrix = Array.from({ length: 90 }, () => Array.from({ length: 90 }, () => 0));
    expect(jsonRows(matrix as never, () => true).length).toBeLessThanOrEqual(500);
    expect(lines({ text: 'x'.repeat(1e6) } as never)[0]!.length).toBeLessThan(1100);
  });
});
