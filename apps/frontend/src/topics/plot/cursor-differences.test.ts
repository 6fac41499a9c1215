import { expect, it } from 'vitest';
import { lineDifference, timeDifference } from './cursor-differences.ts';
import { derivativeOf } from './line-derivative.ts';
import { aLine } from './testing/a-line.ts';

const line = aLine(Array.from({ length: 11 }, (_, i) => [i * 100, i * i]));

it('tells the time between two cursors and how often it fits into a second', () => {
  expect(timeDifference({ aMs: 1000, bMs: 1250 })).toEqual({ deltaMs: 250, hz: 4 });
  expect(timeDifference({ aMs: 1250, bMs: 1000 })).toEqual({ deltaMs: -250, hz: 4 });
  expect(timeDifference({ aMs: 5, bMs: 5 })).toEqual({ deltaMs: 0, hz: undefined });
});

it('tells what a line does at two cursors and between them, in either order', () => {
  const forth = lineDifference(line, { aMs: 210, bMs: 590 }, 1000);
  expect(forth).toMatchObject({ a: 4, b: 36, delta: 32 });
  expect(forth.between).toMatchObject({ count: 3, min: 9, max: 25 });
  const back = lineDifference(line, { aMs: 590, bMs: 210 }, 1000);
  expect(back).toMatchObject({ a: 36, b: 4, delta: -32, between: forth.between });
});

it('reads nothing before the first point', () => {
  const { a, delta } = lineDifference(line, { aMs: -5000, bMs: 500 }, 1000);
  expect([a, delta]).toEqual([undefined, undefined]);
});

it('a derivative is per second, since the moment before', () => {
  const slope = derivativeOf(line);
  expect(slope.valueAt(0)).toBeNaN();
  expect([1, 2, 3].map((i) => slope.valueAt(i))).toEqual([10, 30, 50]);
  const bundled = derivativeOf(
    aLine([
      [0, 0],
      [100, 1],
      [100, 3],
    ]),
  );
  expect(bundled.valueAt(2)).toBe(30);
  const odd = derivativeOf(
    aLine([
      [0, Number.NaN],
      [100, 1],
    ]),
  );
  expect(odd.valueAt(1)).toBeNaN();
});
