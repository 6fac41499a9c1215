import { describe, expect, it } from 'vitest';
import { median, percentile, ratiosOf } from './statistics.ts';

describe('percentile', () => {
  const hundred = Array.from({ length: 100 }, (_, i) => i + 1);

  it('is the value at the nearest rank', () => {
    expect(percentile(hundred, 0.5)).toBe(50);
    expect(percentile(hundred, 0.99)).toBe(99);
    expect(percentile([3, 9], 0.99)).toBe(9);
  });

  it('is the smallest and the largest value at the ends', () => {
    expect(percentile(hundred, 0)).toBe(1);
    expect(percentile(hundred, 1)).toBe(100);
  });

  it('is not a number for no values', () => {
    expect(percentile([], 0.5)).toBeNaN();
  });
});

describe('median', () => {
  it('is the middle, whatever the order', () => {
    expect(median([9, 1, 5])).toBe(5);
    expect(median([100, 20, 3, 1])).toBe(11.5);
  });

  it('is not a number for no values', () => {
    expect(median([])).toBeNaN();
  });
});

describe('ratiosOf', () => {
  it('divides within a round, so that a slow round of both does not count', () => {
    expect(ratiosOf([20, 110, 5], [10, 100, 10])).toEqual([2, 1.1, 0.5]);
  });

  it('refuses values that are not pairs', () => {
    expect(() => ratiosOf([1, 2], [1])).toThrow(RangeError);
  });
});
