import { expect, it } from 'vitest';
import { cardLines } from './card-line.ts';

it('draws no line through a single value', () => {
  expect(cardLines([], 5)).toEqual([]);
  expect(cardLines([[1]], 5)).toEqual([]);
});

it('ends at the right edge, with the lines of a value on one scale', () => {
  const [x, y] = cardLines(
    [
      [0, 2],
      [1, 2],
    ],
    2,
  );
  expect(x).toBe('M24.0 176.0L352.0 122.0');
  expect(y).toBe('M24.0 68.0L352.0 68.0');
  expect(cardLines([[0], [1]], 3)).toEqual(['M188.0 176.0L352.0 68.0']);
});

it('draws values that stand still in the middle, and leaves gaps for what is no number', () => {
  expect(cardLines([[3], [3]], 2)).toEqual(['M24.0 122.0L352.0 122.0']);
  expect(cardLines([[1], [Number.NaN], [2]], 3)).toEqual(['M24.0 176.0M352.0 68.0']);
});
