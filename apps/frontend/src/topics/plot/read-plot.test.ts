import { describe, expect, it } from 'vitest';
import { SeriesRing } from '../history/series-ring.ts';
import { pointAt, pointNear, valuesWithin } from './read-plot.ts';

function ringOf(points: readonly (readonly [number, ...number[]])[]): SeriesRing {
  const ring = new SeriesRing(points[0]!.length - 1);
  for (const [timeMs, ...numbers] of points) ring.push(timeMs, numbers);
  return ring;
}

describe('valuesWithin', () => {
  const ring = ringOf([
    [0, 50, -50],
    [10, 1, 2],
    [20, 3, -4],
    [30, Number.NaN, 9],
    [40, 99, 99],
  ]);

  it('spans all lines, from the point before the window on', () => {
    expect(valuesWithin(ring, 15, 30)).toEqual({ min: -4, max: 9 });
    expect(valuesWithin(ring, 5, 20)).toEqual({ min: -50, max: 50 });
  });

  it('has a range as long as a value is held', () => {
    expect(valuesWithin(ring, 1000, 2000)).toEqual({ min: 99, max: 99 });
    expect(valuesWithin(new SeriesRing(1), 0, 1)).toBeUndefined();
  });
});

describe('pointNear', () => {
  const ring = ringOf([
    [0, 1],
    [10, 2],
    [20, 3],
  ]);

  it('takes the nearest point that is not after the end', () => {
    expect(pointNear(ring, 6, 100)).toEqual({ timeMs: 10, values: [2] });
    expect(pointNear(ring, 4, 100)).toEqual({ timeMs: 0, values: [1] });
    expect(pointNear(ring, -5, 100)).toEqual({ timeMs: 0, values: [1] });
    expect(pointNear(ring, 99, 100)).toEqual({ timeMs: 20, values: [3] });
    expect(pointNear(ring, 16, 15)).toEqual({ timeMs: 10, values: [2] });
  });

  it('finds nothing where there is nothing', () => {
    expect(pointNear(new SeriesRing(1), 0, 1)).toBeUndefined();
  });
});

describe('pointAt', () => {
  const ring = ringOf(Array.from({ length: 20 }, (_, i) => [i < 10 ? i * 10 : 5000 + i * 10, i]));

  it('reads the nearest point, and the newest one until now', () => {
    expect(pointAt(ring, 42, 9000)?.values).toEqual([4]);
    expect(pointAt(ring, 8000, 9000)?.values).toEqual([19]);
  });

  it('reads nothing in a gap and before the first point', () => {
    expect(pointAt(ring, 2500, 9000)).toBeUndefined();
    expect(pointAt(ring, -2000, 9000)).toBeUndefined();
  });
});
