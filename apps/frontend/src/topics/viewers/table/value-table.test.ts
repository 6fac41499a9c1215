import { DATA_FORMATS, type DataFormat, type TopicRecord } from '@ubii/proto';
import { expect, it } from 'vitest';
import { MAX_ROWS, TABLE_FORMATS, valueTable } from './value-table.ts';

const record = (format: DataFormat, value: unknown): TopicRecord =>
  ({ topic: '/a', clientId: '', timestampMs: 0, format, value }) as TopicRecord;

it.each(Object.keys(DATA_FORMATS) as DataFormat[])(
  '%s is a table or not, as it is said',
  (format) => {
    const table = valueTable(record(format, DATA_FORMATS[format].createDefault()));
    expect(table !== undefined).toBe(TABLE_FORMATS.has(format));
  },
);

it('a matrix has its rows and columns', () => {
  const value = { ...DATA_FORMATS.matrix4x4.createDefault(), m03: 5, m10: -0.5 };
  const table = valueTable(record('matrix4x4', value));
  expect(table?.rows[0]).toEqual(['1.000', '0.000', '0.000', '5.000']);
  expect(table?.rows[1]?.[0]).toBe('−0.500');
});

it('a list has a row for each element, up to what can be shown', () => {
  const elements = Array.from({ length: MAX_ROWS + 7 }, (_none, index) => index);
  const table = valueTable(record('int32List', { elements }));
  expect(table).toMatchObject({ count: MAX_ROWS + 7 });
  expect(table?.rows).toHaveLength(MAX_ROWS);
  const pose = { position: { x: 0.1, y: 0.2 } };
  const things = valueTable(record('object2DList', { elements: [{ id: 'cup', pose }] }));
  expect(things?.rows).toEqual([['cup', '0.100', '0.200', '', '']]);
});
