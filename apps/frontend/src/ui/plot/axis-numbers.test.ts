import { expect, it } from 'vitest';
import { formatAxisNumber } from './axis-numbers.ts';

it.each([
  [0, '0'],
  [0.05, '0.05'],
  [0.125, '0.13'],
  [1, '1'],
  [1.5, '1.5'],
  [10, '10'],
  [100, '100'],
  [2000, '2 000'],
  [25_000, '25k'],
  [1_500_000, '1.5M'],
  [-10, '−10'],
])('writes %d as %s', (value, text) => {
  expect(formatAxisNumber(value).replaceAll('\u00a0', ' ')).toBe(text);
});
