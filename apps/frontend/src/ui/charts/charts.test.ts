import { describe, expect, it } from 'vitest';
import { linePath } from './line-path.ts';
import { formatTick, niceScale } from './nice-scale.ts';
import { placeMarks } from './place-marks.ts';
import { nearestPoint, withGaps } from './with-gaps.ts';

describe('niceScale', () => {
  it.each([
    [0, 10],
    [13, 20],
    [450, 500],
    [1842, 2000],
    [2100, 4000],
    [90_000, 100_000],
  ])('shows %d on a scale to %d', (highest, max) => {
    expect(niceScale(highest)).toEqual({ max, ticks: [0, max / 2, max] });
  });

  it('labels ticks with few characters', () => {
    expect([500, 1000, 2500, 2e6].map(formatTick)).toEqual(['500', '1 k', '2.5 k', '2 M']);
  });
});

it('a line is broken where a value is missing', () => {
  const path = linePath([
    { x: 0, y: 1 },
    { x: 1, y: undefined },
    { x: 2, y: 3 },
    { x: 3, y: 4 },
  ]);
  expect(path).toBe('M0.0 1.0M2.0 3.0L3.0 4.0');
});

it('gaps stay gaps', () => {
  const points = [0, 2, 20].map((timeMs) => ({ timeMs, value: timeMs }));
  expect(withGaps(points, 5).map(({ value }) => value)).toEqual([0, 2, undefined, 20]);
});

it('finds the point nearest to a time', () => {
  const points = [0, 10, 20].map((timeMs) => ({ timeMs, value: timeMs }));
  expect([-5, 4, 6, 15, 99].map((timeMs) => nearestPoint(points, timeMs)?.value)).toEqual([
    0, 0, 10, 10, 20,
  ]);
  expect(nearestPoint([], 1)).toBeUndefined();
});

describe('placeMarks', () => {
  const mark = (timeMs: number) => ({ timeMs, text: `at ${timeMs}` });
  const place = (...times: number[]) =>
    placeMarks(
      times.map(mark),
      (timeMs) => timeMs,
      500,
      () => 100,
    );

  it('puts the words to the right of the line, and to the left near the right edge', () => {
    expect(place(50, 450).map(({ side, showText }) => [side, showText])).toEqual([
      ['right', true],
      ['left', true],
    ]);
  });

  it('gives the words to the newer of two that would run into each other', () => {
    expect(place(50, 100).map(({ mark: { timeMs }, showText }) => [timeMs, showText])).toEqual([
      [50, false],
      [100, true],
    ]);
  });

  it('folds marks at the same place into the newest', () => {
    const [only, ...others] = place(100, 104, 108);
    expect(others).toEqual([]);
    expect(only).toMatchObject({ mark: { timeMs: 108 }, folded: 2 });
  });

  it('leaves out what is not on the chart', () => {
    expect(place(-50, 600)).toEqual([]);
  });
});
