import { describe, expect, it } from 'vitest';
import { SPARK_SAMPLES, Sparkline } from './sparkline.ts';

function lineOf(samples: readonly (readonly number[] | undefined)[], isActivity = false) {
  const sparkline = new Sparkline();
  for (const sample of samples) sparkline.add(sample);
  return sparkline.line(isActivity);
}

describe('Sparkline', () => {
  it('keeps the last samples', () => {
    const { values } = lineOf(Array.from({ length: 100 }, (_, i) => [i]));
    expect(values).toHaveLength(SPARK_SAMPLES);
    expect(values.at(-1)).toBe(99);
  });

  it('shows the number that moves most', () => {
    expect(
      lineOf([
        [1, 10],
        [1, 20],
        [1, 15],
      ]).values,
    ).toEqual([10, 20, 15]);
  });

  it('stays with its number while another moves only a little more', () => {
    const sparkline = new Sparkline();
    for (const sample of [
      [0, 0],
      [10, 0],
    ])
      sparkline.add(sample);
    expect(sparkline.line(false).values).toEqual([0, 10]);
    sparkline.add([0, 12]);
    expect(sparkline.line(false).values).toEqual([0, 10, 0]);
    sparkline.add([0, 40]);
    expect(sparkline.line(false).values).toEqual([0, 0, 12, 40]);
  });

  it('draws noise as rest', () => {
    const { min, max } = lineOf([[1000], [1000.1], [999.9]]);
    expect(max! - min!).toBeCloseTo(10, 0);
    expect(lineOf([[1000], [1100]]).min).toBeUndefined();
  });

  it('measures activity from nothing', () => {
    expect(lineOf([[60], [61]], true)).toEqual({ values: [60, 61], min: 0, max: undefined });
  });

  it('leaves gaps, and has no line where there are no numbers', () => {
    expect(lineOf([[1], undefined, [2], [Number.NaN]]).values).toEqual([
      1,
      undefined,
      2,
      undefined,
    ]);
    expect(lineOf([undefined, undefined]).values).toEqual([]);
  });
});
