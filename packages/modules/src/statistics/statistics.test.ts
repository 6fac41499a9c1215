import { describe, expect, it } from 'vitest';
import { Sample } from '../../test/drive-module.ts';
import { WAYS } from '../../test/ways.ts';
import { statistics } from './statistics.ts';

/** Two passes over all values: what the window has to agree with. */
function twoPass(values: readonly number[]) {
  const count = values.length;
  const mean = values.reduce((sum, value) => sum + value, 0) / count;
  const m2 = values.reduce((sum, value) => sum + (value - mean) ** 2, 0);
  return {
    count,
    mean,
    min: Math.min(...values),
    max: Math.max(...values),
    standardDeviation: count > 1 ? Math.sqrt(m2 / (count - 1)) : 0,
    rms: Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / count),
  };
}

describe.each(WAYS)('statistics %s', (_way, drive) => {
  it('knows one value', async () => {
    const module = await drive(statistics);
    expect(await module.run(0, { value: -3 })).toEqual({
      count: 1,
      mean: -3,
      min: -3,
      max: -3,
      standardDeviation: 0,
      rms: 3,
    });
  });

  it('counts 0 while there is nothing', async () => {
    const module = await drive(statistics);
    expect(await module.run(0)).toEqual({ count: 0 });
    expect(await module.run(10, { value: NaN })).toEqual({ count: 0 });
    expect(await module.run(10, { value: Infinity })).toEqual({ count: 0 });
  });

  it('knows textbook numbers', async () => {
    const module = await drive(statistics);
    let outputs = {};
    for (const value of [2, 4, 4, 4, 5, 5, 7, 9]) outputs = await module.run(1, { value });
    expect(outputs).toMatchObject({ count: 8, mean: 5, min: 2, max: 9 });
    expect(outputs).toMatchObject({ standardDeviation: expect.closeTo(Math.sqrt(32 / 7), 12) });
    expect(outputs).toMatchObject({ rms: expect.closeTo(Math.sqrt(29), 12) });
  });

  it('agrees with two passes over the window, wherever it is', async () => {
    const module = await drive(statistics);
    const values: number[] = [];
    await module.run(0, { windowMs: 95 }, ['windowMs']);
    for (let i = 0; i < 60; i++) {
      values.push(Math.sin(i) * 10 + (i % 7));
      const outputs = await module.run(10, { value: values.at(-1) }, ['value']);
      const expected = twoPass(values.slice(-10));
      for (const [name, value] of Object.entries(expected)) {
        expect(outputs[name], name).toBeCloseTo(value, 10);
      }
    }
  });

  it('drops by count, and by whichever of both holds less', async () => {
    const module = await drive(statistics);
    await module.run(0, { windowCount: 3, windowMs: 0 }, ['windowCount']);
    for (const value of [1, 2, 3]) await module.run(10_000, { value }, ['value']);
    expect(await module.run(10_000, { value: 4 })).toMatchObject({ count: 3, min: 2, max: 4 });
    expect(await module.run(0, { windowMs: 15_000 }, ['windowMs'])).toMatchObject({
      count: 2,
      min: 3,
    });
    expect(await module.run(60_000, {}, ['windowMs'])).toEqual({ count: 0 });
  });

  it('is exact for small differences of large numbers', async () => {
    const module = await drive(statistics);
    let outputs = {};
    for (const value of [4, 7, 13, 16]) outputs = await module.run(1, { value: 1e9 + value });
    expect(outputs).toMatchObject({ mean: 1e9 + 10, standardDeviation: Math.sqrt(30) });
  });

  it('forgets an outlier completely', async () => {
    const module = await drive(statistics);
    await module.run(0, { windowCount: 2, value: 1e100 });
    await module.run(1, { value: 1 });
    expect(await module.run(1, { value: 2 })).toMatchObject({
      count: 2,
      mean: 1.5,
      max: 2,
      standardDeviation: Math.SQRT1_2,
    });
  });

  it('leaves NaN out but keeps what it has', async () => {
    const module = await drive(statistics);
    await module.run(0, { value: 1 });
    expect(await module.run(10, { value: NaN })).toMatchObject({ count: 1, mean: 1 });
    expect(await module.run(2000)).toEqual({ count: 0 });
  });

  it('counts a value again in runs that nothing triggers, not in those of a parameter', async () => {
    const sampled = await drive(statistics);
    await sampled.run(0, { value: 1 });
    expect(await sampled.run(10)).toMatchObject({ count: 2 });
    const triggered = await drive(statistics);
    await triggered.run(0, { value: 1 }, ['value']);
    expect(await triggered.run(10, { windowMs: 500 }, ['windowMs'])).toMatchObject({ count: 1 });
  });

  it('keeps at most 10 000 values', async () => {
    const module = await drive(statistics);
    await module.run(0, { windowMs: 0, windowCount: 1_000_000 }, ['windowMs']);
    for (let i = 0; i < 10_050; i++) await module.run(0, { value: i }, ['value']);
    expect(await module.run(0, {}, ['windowMs'])).toMatchObject({ count: 10_000, min: 50 });
  });

  it('clamps negative windows to 0, and uses defaults for those that are not finite', async () => {
    const module = await drive(statistics);
    await module.run(0, { windowMs: NaN, windowCount: -4, value: 1 });
    expect(await module.run(999, { value: 2 })).toMatchObject({ count: 2 });
    expect(await module.run(1, { value: 3 })).toMatchObject({ count: 2, min: 2 });
  });

  it('takes any number format [PM-31]', async () => {
    const module = await drive(statistics);
    expect(await module.run(0, { value: new Sample(3, { type: 'int32' }) })).toMatchObject({
      mean: 3,
    });
  });
});
