import { DATA_FORMATS, encodeRecord, type DataFormat } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { checkRecord, formatOfJson, newRecord, readRecord } from './record-json.ts';
import { fillIn, unknownVariables, variableSource } from './variables.ts';

const source = {
  uuid: () => 'u-1',
  timestamp: () => '1000',
  counter: () => '7',
  random: () => '0.5',
};

describe('a record as JSON', () => {
  it.each(Object.keys(DATA_FORMATS) as DataFormat[])(
    '%s begins as one that can be sent',
    (format) => {
      const json = newRecord('/a', format);
      expect(checkRecord(json, source)).toEqual([]);
      const record = readRecord(json, source);
      expect(record).toMatchObject({ topic: '/a', format });
      expect(() => encodeRecord(record as never)).not.toThrow();
    },
  );

  it('says what is missing and what is wrong', () => {
    expect(checkRecord({ topic: '', double: 'abc' }, source)).toEqual([
      { path: 'double', sentence: 'must be a number, got "abc"' },
      { path: 'topic', sentence: 'must not be empty. Example: /lab/light.' },
    ]);
    expect(checkRecord({ topic: '/a' }, source)).toEqual([
      { path: '', sentence: 'The record has no value. Add one, for example "double": 0.5.' },
    ]);
    expect(checkRecord({ topic: 5, double: 1 }, source)).toEqual([
      { path: 'topic', sentence: 'must be a text in double quotes' },
    ]);
    expect(checkRecord({ topic: [], double: 1 }, source)).toHaveLength(1);
    expect(checkRecord({ topic: '/a', double: 1, timestamp: {} }, source)[0]!.path).toBe(
      'timestamp',
    );
    const image = { width: 2, height: 2, dataFormat: 'GRAY8', data: '' };
    expect(checkRecord({ topic: '/a', image2D: image }, source)[0]).toMatchObject({
      path: 'image2D.data',
    });
  });

  it('takes variables where numbers and texts stand', () => {
    const json = { topic: '/robot/{{uuid}}', vector2: { x: '{{counter}}', y: '{{ random }}' } };
    expect(checkRecord(json, source)).toEqual([]);
    expect(readRecord(json, source)).toEqual({
      topic: '/robot/u-1',
      format: 'vector2',
      value: { x: 7, y: 0.5 },
    });
    expect(formatOfJson(json)).toBe('vector2');
    expect(fillIn(['{{timestamp}} ms', '{{other}}'], source)).toEqual(['1000 ms', '{{other}}']);
    expect(unknownVariables('{{counter}} {{ nope }} {{nope}} {{x}}')).toEqual(['nope', 'x']);
    expect(unknownVariables('{{uuid}} {a} {{a b}}')).toEqual([]);
    expect(variableSource(() => 3).counter()).toBe('3');
  });
});
