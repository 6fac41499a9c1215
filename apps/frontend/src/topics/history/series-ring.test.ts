import { describe, expect, it } from 'vitest';
import { SeriesRing } from './series-ring.ts';

const MAX_POINTS = 5000;

describe('SeriesRing', () => {
  it('keeps points in order while it grows and after it is full', () => {
    const ring = new SeriesRing(2, MAX_POINTS);
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
    const ring = new SeriesRing(1, MAX_POINTS);
    for (const time of [10, 20, 20, 30]) ring.push(time, [time]);
    expect([5, 10, 15, 20, 30, 31].map((time) => ring.indexAtOrAfter(time))).toEqual([
      0, 0, 1, 1, 3, 4,
    ]);
    expect(new SeriesRing(1, MAX_POINTS).indexAtOrAfter(0)).toBe(0);
  });

  it('never goes back in time, so that windows can be found', () => {
    const ring = new SeriesRing(1, MAX_POINTS);
    ring.push(100, [1]);
    ring.push(90, [2]);
    expect(ring.timeAt(1)).toBe(100);
  });

  it('fills what a point does not have with NaN', () => {
    const ring = new SeriesRing(2, MAX_POINTS);
    ring.push(0, [1]);
    expect(ring.valueAt(1, 0)).toBeNaN();
  });

  it('forgets what is too old, and points beyond what it may keep', () => {
    const ring = new SeriesRing(1, 4000);
    for (let i = 0; i < 3000; i++) ring.push(i, [i]);
    ring.dropBefore(1000);
    expect([ring.size, ring.timeAt(0), ring.pushed]).toEqual([2000, 1000, 3000]);
    ring.setMaxPoints(500);
    expect([ring.size, ring.timeAt(0), ring.valueAt(0, 499)]).toEqual([500, 2500, 2999]);
    ring.push(3000, [3000]);
    expect([ring.size, ring.timeAt(0), ring.timeAt(499)]).toEqual([500, 2501, 3000]);
    expect(ring.bytes).toBe(2 * 500 * 8);
  });

  it('takes another line from the next point on', () => {
    const ring = new SeriesRing(0, 10);
    const first = ring.addLine();
    ring.push(0, [1]);
    const second = ring.line(ring.addLine());
    ring.push(1, [2, 3]);
    expect(ring.valueAt(first, 1)).toBe(2);
    expect([second.valueAt(0), second.valueAt(1)]).toEqual([Number.NaN, 3]);
  });
});
