import { expect, it } from 'vitest';
import { adaptRate } from './adapt-rate.ts';

it('sends little more than the module looks at', () => {
  expect(adaptRate(30, 30, 29, 10)).toBeCloseTo(11.5);
  expect(adaptRate(30, 30, 29, 0.1)).toBe(1);
});

it('goes back up to what is wanted while the module keeps up', () => {
  let rateHz = 4;
  for (let step = 0; step < 20; step++) rateHz = adaptRate(rateHz, 30, rateHz, rateHz * 0.95);
  expect(rateHz).toBe(30);
});

it('stays while nothing is measured', () => {
  expect(adaptRate(12, 30, undefined, 3)).toBe(12);
  expect(adaptRate(12, 30, 12, undefined)).toBe(12);
});
