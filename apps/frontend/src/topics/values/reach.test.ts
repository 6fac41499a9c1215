import { expect, it } from 'vitest';
import { formatFixed } from './format-value.ts';
import { Reach, reachOf } from './reach.ts';

it('keeps the form of a value that passes zero', () => {
  const reach = new Reach();
  const texts = [0.8, 0.05, 7.3e-5, -0.0004, -0.6].map((value, i) => {
    reach.add([value], i * 100);
    return formatFixed(value, 2, reach.value);
  });
  expect(texts).toEqual(['0.80', '0.05', '0.00', '0.00', '−0.60']);
});

it('forgets large values after a while', () => {
  const reach = new Reach();
  reach.add([4], 0);
  reach.add([0.01], 6000);
  expect(reach.value).toBe(4);
  reach.add([0.01], 11_500);
  expect(reach.value).toBe(0.01);
});

it('ignores what is not a number', () => {
  expect(reachOf([Number.NaN, -2, Infinity, undefined])).toBe(2);
  expect(reachOf([])).toBe(0);
});
