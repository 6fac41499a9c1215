import { describe, expect, it } from 'vitest';
import { nameProblem } from './client-name.ts';
import { readThrottleRate, suggestThrottleRate } from './throttle-rate.ts';

describe('nameProblem', () => {
  it('refuses what the master refuses, with the reason [EX-29]', () => {
    expect(nameProblem(' Anna ')).toBeUndefined();
    expect(nameProblem('  ')).toContain('at least one character');
    expect(nameProblem('x'.repeat(61))).toContain('maximum is 60');
    expect(nameProblem('a\nb')).toContain('one line');
  });
});

describe('throttle rate', () => {
  it('is a number of 0.1 or more [EX-31]', () => {
    expect(readThrottleRate(' 30 ')).toEqual({ rate: 30 });
    expect(readThrottleRate('0,5')).toEqual({ rate: 0.5 });
    for (const text of ['', 'ten', '0', '-1', 'Infinity', '1e999']) {
      expect(readThrottleRate(text), text).toHaveProperty('problem');
    }
  });

  it.each([
    [0, 1],
    [1.5, 1],
    [30, 10],
    [250, 100],
    [9000, 4000],
  ])('for %d records per second, %d is worth trying', (rate, suggestion) => {
    expect(suggestThrottleRate(rate)).toBe(suggestion);
  });
});
