import { describe, expect, it } from 'vitest';
import { WAYS } from '../../test/ways.ts';
import { mapRange } from './map-range.ts';

describe.each(WAYS)('map-range %s', (_way, drive) => {
  async function map(inputs: { [name: string]: unknown }): Promise<unknown> {
    const module = await drive(mapRange);
    return (await module.run(0, inputs)).mapped;
  }

  it('clamps to 0 to 1 with nothing but a value', async () => {
    expect(await map({ value: 0.3 })).toBeCloseTo(0.3, 12);
    expect(await map({ value: -1 })).toBe(0);
    expect(await map({ value: 7 })).toBe(1);
  });

  it('maps one range to another and meets both ends exactly', async () => {
    const ranges = { inMin: -0.1, inMax: 0.2, outMin: 0.1, outMax: 0.7 };
    expect(await map({ value: -0.1, ...ranges })).toBe(0.1);
    expect(await map({ value: 0.2, ...ranges })).toBe(0.7);
    expect(await map({ value: 0.05, ...ranges })).toBeCloseTo(0.4, 12);
  });

  it('never leaves a range that it clamps to, not even by rounding', async () => {
    const module = await drive(mapRange);
    await module.run(0, { inMin: 0.1, inMax: 0.7, outMin: 0.3, outMax: 0.9 });
    for (let i = 0; i <= 600; i++) {
      const { mapped } = await module.run(1, { value: 0.1 + i / 1000 });
      expect(mapped).toBeGreaterThanOrEqual(0.3);
      expect(mapped).toBeLessThanOrEqual(0.9);
    }
  });

  it('goes beyond the range when it does not clamp', async () => {
    const ranges = { inMin: 0, inMax: 10, outMin: 0, outMax: 100, clamp: false };
    expect(await map({ value: 15, ...ranges })).toBe(150);
    expect(await map({ value: -5, ...ranges })).toBe(-50);
  });

  it('takes ranges that run backwards', async () => {
    expect(await map({ value: 8, inMin: 10, inMax: 0 })).toBeCloseTo(0.2, 12);
    expect(await map({ value: 0.25, outMin: 8, outMax: 0 })).toBe(6);
  });

  it('inverts after the curve', async () => {
    expect(await map({ value: 0.25, invert: true })).toBe(0.75);
    expect(await map({ value: 0.5, exponent: 2 })).toBe(0.25);
    expect(await map({ value: 0.5, exponent: 2, invert: true })).toBe(0.75);
    expect(await map({ value: -0.5, exponent: 2, clamp: false })).toBe(-0.25);
  });

  it('is a step where the range is empty', async () => {
    const empty = { inMin: 5, inMax: 5, outMin: 1, outMax: 2 };
    expect(await map({ value: 4.9, ...empty })).toBe(1);
    expect(await map({ value: 5, ...empty })).toBe(2);
  });

  it('clamps exponents to 0.01 to 100, and uses defaults for parameters that are not finite', async () => {
    expect(await map({ value: 0.5, exponent: -1 })).toBeCloseTo(0.5 ** 0.01, 12);
    expect(await map({ value: 0.5, exponent: 1e9 })).toBeCloseTo(0.5 ** 100, 40);
    expect(await map({ value: 0.5, exponent: NaN, inMax: Infinity })).toBe(0.5);
  });

  it('says nothing for NaN, and the end of the range for infinity', async () => {
    expect(await map({})).toBeUndefined();
    expect(await map({ value: NaN })).toBeUndefined();
    expect(await map({ value: Infinity, outMax: 9 })).toBe(9);
    expect(await map({ value: -Infinity, outMax: 9 })).toBe(0);
    expect(await map({ value: Infinity, clamp: false })).toBeUndefined();
  });
});
