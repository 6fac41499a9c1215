import { DATA_FORMATS, type DataFormat } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import { formatFixed, formatInRange, formatValue } from './format-value.ts';

const line = (format: DataFormat, value: unknown): string => formatValue(format, value as never);
const jpeg = (bytes: number) => Object.assign(new Uint8Array(bytes), [0xff, 0xd8, 0xff]);

describe('formatValue', () => {
  it.each<[DataFormat, unknown, string]>([
    ['double', 284.6, '284.60'],
    ['double', -0.5, '−0.50'],
    ['double', 0.00012, '0.00012'],
    ['double', 1.2e-9, '1.2e−9'],
    ['double', Number.NaN, 'NaN'],
    ['int32', -1842, `−${formatNumber(1842)}`],
    ['bool', true, 'true'],
    ['string', '{\n  "stage": "2m"\n}', '{ "stage": "2m" }'],
    ['string', '', '""'],
    ['vector2', { x: 0.4121, y: 0.7079 }, '0.412, 0.708'],
    ['vector3', { x: 0.21, y: -0.38, z: 9.74 }, '0.21, −0.38, 9.74'],
    ['vector3', { x: 7.3e-5, y: 0, z: 9.81 }, '0.00, 0.00, 9.81'],
    ['quaternion', { x: 0.11, y: 0, z: 0, w: 0.92 }, 'x 0.11 y 0.00 z 0.00 w 0.92'],
    ['doubleList', { elements: [0.318] }, '[0.32]'],
    ['doubleList', { elements: [1, 2, 3, 4, 5] }, '5 × double'],
    ['boolList', { elements: [true] }, '[true]'],
    ['stringList', { elements: ['a', 'b'] }, '["a", "b"]'],
    ['vector2List', { elements: [{}, {}] }, '2 × vector2'],
    ['touchEvent', { type: 1, position: { x: 0.1, y: 0.2 } }, 'touch_move 0.100, 0.200'],
    [
      'touchEventList',
      { elements: [{ type: 0 }, { type: 1 }] },
      '2 touches: touch_start, touch_move',
    ],
    ['keyEvent', { key: 'Enter', type: 1 }, 'Enter down'],
    ['mouseEvent', { button: 0, type: 0 }, 'button 0 up'],
    ['object2DList', { elements: [{ id: 'person' }, { id: 'cup' }] }, '2 objects: person, cup'],
    ['object2DList', { elements: [] }, '0 objects'],
    [
      'image2D',
      { width: 640, height: 480, dataFormat: 0, data: jpeg(38_200) },
      '640×480 JPEG, 38 kB',
    ],
    [
      'image2D',
      { width: 2, height: 2, dataFormat: 2, data: new Uint8Array(16) },
      '2×2 RGBA8, 16 B',
    ],
    ['error', { title: 'Refused', message: 'No room' }, 'Refused: No room'],
    ['recordingStatus', { running: [{ name: 'Lesson 3' }] }, '1 recording: Lesson 3'],
    ['replayList', { elements: [{ name: 'Lesson 3' }] }, '1 replay: Lesson 3'],
    ['studyStatus', { runs: [{ block: 2 }] }, '1 run'],
    ['sessionStatistics', { modules: [{ moduleName: 'smooth' }] }, '1 module: smooth'],
    [
      'moduleEvent',
      { moduleName: 'smooth', moduleId: 'm', kind: 2, message: 'Out of time' },
      'smooth killed: Out of time',
    ],
  ])('%s', (format, value, text) => {
    expect(line(format, value)).toBe(text);
  });

  it('has a line for the neutral value of every data format', () => {
    for (const { format, createDefault } of Object.values(DATA_FORMATS)) {
      const text = line(format, createDefault());
      expect(typeof text).toBe('string');
      expect(text).not.toMatch(/undefined|\[object|-/);
    }
  });

  it('stays short and in one line whatever comes', () => {
    const text = 'word\n'.repeat(100_000);
    expect(line('string', text).length).toBeLessThan(300);
    expect(line('stringList', { elements: [text, text] }).length).toBeLessThan(300);
    expect(line('object2DList', { elements: Array(5000).fill({ id: text }) }).length).toBeLessThan(
      300,
    );
    expect(line('string', text)).not.toContain('\n');
  });
});

describe('formatFixed', () => {
  it('keeps the decimals, and a tiny value in sight', () => {
    expect(formatFixed(0, 2)).toBe('0.00');
    expect(formatFixed(9.999, 2)).toBe('10.00');
    expect(formatFixed(-0.000_04, 3)).toBe('−0.000040');
    expect(formatFixed(-4e-8, 3)).toBe('−4.0e−8');
  });

  it('writes the numbers of one reach alike', () => {
    expect([0.4, 7.3e-5, -0.2].map((value) => formatFixed(value, 2, 0.4))).toEqual([
      '0.40',
      '0.00',
      '−0.20',
    ]);
    expect([0.0004, 7.3e-5, 0].map((value) => formatFixed(value, 2, 0.0004))).toEqual([
      '0.00040',
      '0.00007',
      '0.00000',
    ]);
  });
});

describe('formatInRange', () => {
  const write = (values: readonly number[], min: number, max: number) =>
    values.map((value) => formatInRange(value, { min, max }));

  it('takes the decimals from the range, one for all numbers', () => {
    expect(write([0, 7.3e-5, -0.4], -1, 1)).toEqual(['0.00', '0.00', '−0.40']);
    expect(write([0, 7.3e-5], -1e-4, 1e-4)).toEqual(['0.000000', '0.000073']);
    expect(write([1200.4, 0], -2000, 2000)).toEqual([formatNumber(1200), '0']);
  });

  it('writes exponents only where decimals do not help, for all numbers', () => {
    expect(write([7.3e-9, 1e-12], -1e-8, 1e-8)).toEqual(['7.30e−9', '1.00e−12']);
  });
});
