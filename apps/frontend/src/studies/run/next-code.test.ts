import { expect, it } from 'vitest';
import { nextCode } from './next-code.ts';

it.each([
  [[], 'P01'],
  [['P06', 'P05'], 'P07'],
  [['P02', 'P10', 'P01'], 'P11'],
  [['P09'], 'P10'],
  [['P099'], 'P100'],
  [['S3', 'P07'], 'S4'],
  [['pilot'], 'P01'],
  [['pilot', 'A1b2'], 'A1b3'],
])('after %j comes %s', (codes, next) => {
  expect(nextCode(codes)).toBe(next);
});
