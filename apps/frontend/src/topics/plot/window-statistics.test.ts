import { describe, expect, it } from 'vitest';
import { SeriesRing } from '../history/series-ring.ts';
import { statisticsOf } from './window-statistics.ts';

describe('statisticsOf', () => {
  it('describes the values of the window only', () => {
    const ring = new SeriesRing(1);
    [100, 2, 4, 4, 4, 5, 5, 7, 9, -100].forEach((value, i) => ring.push(i, [value]));
    expect(statisticsOf(ring, 0, 1, 8)).toEqual({ min: 2, mean: 5, max: 9, deviation: 2 });
  });

  it('has nothing to say about an empty window', () => {
    const ring = new SeriesRing(1);
    ring.push(0, [Number.NaN]);
    expect(statisticsOf(ring, 0, 0, 10)).toBeUndefined();
  });

  it('keeps its digits when the values are far from 0', () => {
    const ring = new SeriesRing(1);
    for (let i = 0; i < 1000; i++) ring.push(i, [1e9 + (i % 2)]);
    expect(statisticsOf(ring, 0, 0, 1000)?.deviation).toBeCloseTo(0.5, 6);
  });
});
