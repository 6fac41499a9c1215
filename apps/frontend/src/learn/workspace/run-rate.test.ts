import { expect, it } from 'vitest';
import { createRunRate } from './run-rate.ts';

it('measures runs per second over the last second', () => {
  let ms = 0;
  const rate = createRunRate(() => ms);
  expect(rate.measure(0)).toBe(0);
  ms = 500;
  expect(rate.measure(15)).toBe(30);
  ms = 1500;
  expect(rate.measure(75)).toBe(60);
  ms = 2500;
  expect(rate.measure(75)).toBe(0);
  ms = 3000;
  expect(rate.measure(3)).toBe(0);
});
