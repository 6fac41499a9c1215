import { describe, expect, it } from 'vitest';

import { Random } from '../random.ts';
import { judgeGrowth, median } from './measure.ts';

const TOLERANCE = { relative: 0.1, absolute: 5 };

/** A series of a hundred samples, with noise that is the same in every run. */
function series(value: (index: number) => number, noise = 4): number[] {
  const random = new Random(13);
  return Array.from({ length: 100 }, (_, index) => value(index) + random.below(noise) - noise / 2);
}

describe('growth of a series', () => {
  it('is not found in noise around one value', () => {
    expect(
      judgeGrowth(
        series(() => 200, 60),
        TOLERANCE,
      ).isGrown,
    ).toBe(false);
  });

  it('is found where every turn leaves a little behind', () => {
    const growth = judgeGrowth(
      series((index) => 200 + index / 2),
      TOLERANCE,
    );
    expect(growth).toMatchObject({ isGrown: true, isRising: true });
    expect(growth.more).toBeGreaterThan(30);
  });

  it('is found in a leap that does not go back, too', () => {
    expect(
      judgeGrowth(
        series((index) => (index < 50 ? 200 : 260)),
        TOLERANCE,
      ).isGrown,
    ).toBe(true);
  });

  it('is not found in peaks, however high', () => {
    const peaks = series((index) => (index % 7 === 0 ? 5_000 : 200));
    expect(judgeGrowth(peaks, TOLERANCE).isGrown).toBe(false);
  });

  it('is not found in a saw, which falls as often as it rises', () => {
    expect(
      judgeGrowth(
        series((index) => 200 + (index % 10) * 10),
        TOLERANCE,
      ).isGrown,
    ).toBe(false);
  });

  it('tolerates the larger of both amounts, and tells of a rise below it', () => {
    const slow = (value: number): readonly number[] =>
      Array.from({ length: 100 }, (_, index) => value + index / 10);
    expect(judgeGrowth(slow(10), { relative: 0, absolute: 5 }).isGrown).toBe(true);
    expect(judgeGrowth(slow(10), { relative: 0, absolute: 9 })).toMatchObject({
      isGrown: false,
      isRising: true,
    });
    expect(judgeGrowth(slow(200), { relative: 0.1, absolute: 5 }).isGrown).toBe(false);
  });

  it('takes eight samples', () => {
    expect(() => judgeGrowth([1, 2, 3, 4, 5, 6, 7], TOLERANCE)).toThrow('eight samples');
    expect(judgeGrowth([1, 1, 2, 2, 3, 3, 4, 4], TOLERANCE).quarters).toEqual([1, 2, 3, 4]);
  });

  it('has the median of an even number between the two in the middle', () => {
    expect(median([9, 1, 4, 2])).toBe(3);
    expect(median([9, 1, 4])).toBe(4);
  });
});
