import { describe, expect, it } from 'vitest';
import { pointAt, pointNear } from './read-plot.ts';
import { aLine } from './testing/a-line.ts';

describe('pointNear', () => {
  const line = aLine([
    [0, 1],
    [10, 2],
    [20, 3],
  ]);

  it('takes the nearest point that is not after the end', () => {
    expect(pointNear(line, 6, 100)).toEqual({ timeMs: 10, value: 2 });
    expect(pointNear(line, 4, 100)).toEqual({ timeMs: 0, value: 1 });
    expect(pointNear(line, -5, 100)).toEqual({ timeMs: 0, value: 1 });
    expect(pointNear(line, 99, 100)).toEqual({ timeMs: 20, value: 3 });
    expect(pointNear(line, 16, 15)).toEqual({ timeMs: 10, value: 2 });
  });

  it('finds nothing where there is nothing', () => {
    expect(pointNear(aLine([]), 0, 1)).toBeUndefined();
  });
});

describe('pointAt', () => {
  const line = aLine(Array.from({ length: 20 }, (_, i) => [i < 10 ? i * 10 : 5000 + i * 10, i]));

  it('reads the nearest point, and the newest one until now', () => {
    expect(pointAt(line, 42, 9000)?.value).toBe(4);
    expect(pointAt(line, 8000, 9000)?.value).toBe(19);
  });

  it('reads nothing in a gap and before the first point', () => {
    expect(pointAt(line, 2500, 9000)).toBeUndefined();
    expect(pointAt(line, -2000, 9000)).toBeUndefined();
    expect(pointAt(aLine([[100, 1]]), 50, 9000)).toBeUndefined();
    expect(pointAt(aLine([[100, 1]]), 150, 9000)?.value).toBe(1);
  });
});
