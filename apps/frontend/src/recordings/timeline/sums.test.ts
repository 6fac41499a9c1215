import { expect, it } from 'vitest';
import { sumsOf } from './sums.ts';

it('shares counts at edges, so that an even rate stays even', () => {
  const sums = sumsOf(Float32Array.of(1, 1, 1, 1, 1), 3);
  for (const sum of sums) expect(sum).toBeCloseTo(5 / 3);
  expect(sumsOf([4, 0, 2, 2], 2)).toEqual([4, 4]);
  expect(sumsOf([6], 3)).toEqual([2, 2, 2]);
  expect(sumsOf([], 2)).toEqual([0, 0]);
});
