import { describe, expect, it } from 'vitest';
import { MAX_POINTS, SeriesRing } from './series-ring.ts';

describe('SeriesRing', () => {
  it('keeps points in order while it grows and after it is full', () => {
    const ring = new SeriesRing(2);
    const total = MAX_POINTS + 10_000;
    for (let i = 0; i < total; i++) ring.push(i, [i, -i]);
    expect(ring.size).toBe(MAX_POINTS);
    for (const index of [0, 1, 777, MAX_POINTS - 1]) {
      const expected = total - MAX_POINTS + index;
      expect(ring.timeAt(index)).toBe(expected);
      expect([ring.valueAt(0, index), ring.valueAt(1, index)]).toEqual([expected, -expected]);
    }
  });

  it('finds the first point of a window', () => {
    const ring = new SeriesRing(1);
    for (const time of [10, 20, 20, 30]) ring.push(time, [time]);
    expect([5, 10, 15, 20, 30, 31].map((time) => ring.indexAtOrAfter(time))).toEqual([
      0, 0, 1, 1, 3, 4,
    ]);
    expect(new SeriesRing(1).indexAtOrAfter(0)).toBe(0);
  });

  it('never goes back in time, so that windows can be found', () => {
    const ring = new SeriesRing(1);
    ring.push(100, [1]);
    ring.push(90, [2]);
    expect(ring.timeAt(1)).toBe(100);
  });

  it('fills what a point does not have with NaN', () => {
    const ring = new SeriesRing(2);
    ring.push(0, [1]);
    expect(ring.valueAt(1, 0)).toBeNaN();
  });
});
