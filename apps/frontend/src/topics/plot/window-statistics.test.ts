import { describe, expect, it } from 'vitest';
import { aLine } from './testing/a-line.ts';
import { statisticsOf } from './window-statistics.ts';

describe('statisticsOf', () => {
  it('describes the values of the window only', () => {
    const line = aLine([100, 2, 4, 4, 4, 5, 5, 7, 9, -100].map((value, i) => [i, value]));
    expect(statisticsOf(line, 1, 8)).toEqual({
      count: 8,
      min: 2,
      mean: 5,
      max: 9,
      deviation: 2,
      odd: 0,
    });
  });

  it('counts what is no number, and nothing else of it', () => {
    const line = aLine([
      [0, Number.NaN],
      [1, 3],
      [2, Infinity],
    ]);
    expect(statisticsOf(line, 0, 10)).toMatchObject({ count: 1, mean: 3, max: 3, odd: 2 });
    expect(statisticsOf(line, 2, 10)).toBeUndefined();
  });

  it('keeps its digits when the values are far from 0', () => {
    const line = aLine(Array.from({ length: 1000 }, (_, i) => [i, 1e9 + (i % 2)]));
    expect(statisticsOf(line, 0, 1000)?.deviation).toBeCloseTo(0.5, 6);
  });
});
