import { expect, it } from 'vitest';
import { RunRate } from './run-statistics.ts';

it('follows a fast module from one report to the next', () => {
  const rate = new RunRate(0);
  expect(rate.take(60, 1000)).toBe(60);
  expect(rate.take(90, 2000)).toBe(30);
});

it('[PM-80] does not jump between 0 and 1 for a module that runs less than once a second', () => {
  const rate = new RunRate(0);
  let runs = 0;
  const rates = Array.from({ length: 20 }, (_one, second) => {
    if (second % 2 === 0) runs++;
    return rate.take(runs, (second + 1) * 1000);
  });
  for (const hz of rates.slice(5)) expect(hz).toBeCloseTo(0.5, 0.5);
  for (const hz of rates.slice(5)) expect(hz).toBeGreaterThan(0.3);
});

it('tells at once that a fast module has stopped', () => {
  const rate = new RunRate(0);
  expect(rate.take(60, 1000)).toBe(60);
  expect(rate.take(60, 2000)).toBe(0);
  expect(rate.take(60, 3000)).toBe(0);
});

it('comes to 0 when nothing runs any more', () => {
  const rate = new RunRate(0);
  rate.take(3, 1000);
  for (let second = 2; second <= 6; second++) rate.take(3, second * 1000);
  expect(rate.take(3, 7000)).toBe(0);
});
