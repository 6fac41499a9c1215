import { expect, it } from 'vitest';
import { charactersIn, readLines } from './line-texts.ts';
import { aLine } from './testing/a-line.ts';

const line = (key: string, values: readonly number[]) => ({
  key,
  points: aLine(values.map((value, i) => [i * 10, value])),
});

it('reads all lines at one instant, in the form of their range', () => {
  const range = { min: -1, max: 1 };
  const lines = [line('x', [1, 0.000_07, -1]), line('y', [0.5, 0.25, 0.125])];
  const texts = readLines(lines, [range, range], 15);
  expect(texts.get('x')).toEqual({ timeMs: 10, value: 0.000_07, text: '0.00' });
  expect(texts.get('y')?.text).toBe('0.25');
});

it('has nothing for a line without a point', () => {
  expect(readLines([line('x', [])], [{ min: 0, max: 1 }], 5).size).toBe(0);
});

it('knows how wide the values of a range are', () => {
  expect(charactersIn({ min: -1, max: 1 })).toBe(5);
  expect(charactersIn({ min: 0, max: 100 })).toBe(3);
});
