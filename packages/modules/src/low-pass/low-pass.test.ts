import { describe, expect, it } from 'vitest';
import { Sample, type DrivenModule } from '../../test/drive-module.ts';
import { WAYS } from '../../test/ways.ts';
import {
  lowPass,
  lowPassQuaternion,
  lowPassVector2,
  lowPassVector3,
  lowPassVector4,
} from './low-pass.ts';

async function step(module: DrivenModule, deltaTimeMs: number, value: unknown): Promise<unknown> {
  return (await module.run(deltaTimeMs, { value }, ['value'])).smoothed;
}

describe.each(WAYS)('low-pass %s', (_way, drive) => {
  it('starts at the first value', async () => {
    const module = await drive(lowPass);
    expect(await module.run(0)).toEqual({});
    expect(await step(module, 500, 42)).toBe(42);
  });

  it('comes within 1/e of a step after one time constant', async () => {
    const module = await drive(lowPass);
    await module.run(0, { cutoffHz: 2 });
    await step(module, 0, 0);
    const timeConstantMs = 1000 / (2 * Math.PI * 2);
    expect(await step(module, timeConstantMs, 1)).toBeCloseTo(1 - 1 / Math.E, 12);
  });

  it('takes many short steps as far as one long one', async () => {
    const short = await drive(lowPass);
    const long = await drive(lowPass);
    await step(short, 0, 0);
    await step(long, 0, 0);
    let smoothed: unknown;
    for (const deltaTimeMs of [1, 7, 0, 32, 60]) smoothed = await step(short, deltaTimeMs, 1);
    expect(smoothed).toBeCloseTo((await step(long, 100, 1)) as number, 12);
  });

  it('is as good as at the new value after a long gap', async () => {
    const module = await drive(lowPass);
    await step(module, 0, 0);
    expect(await step(module, 60_000, 5)).toBe(5);
  });

  it('stands still at 0 Hz and follows at once at many', async () => {
    const module = await drive(lowPass);
    await module.run(0, { cutoffHz: 0 });
    await step(module, 0, 1);
    expect(await step(module, 1000, 2)).toBe(1);
    await module.run(0, { cutoffHz: -3 }, ['cutoffHz']);
    expect(await step(module, 1000, 2)).toBe(1);
    await module.run(0, { cutoffHz: 1e9 }, ['cutoffHz']);
    expect(await step(module, 1000, 2)).toBe(2);
  });

  it('never overshoots, not even by rounding', async () => {
    const module = await drive(lowPass);
    await module.run(0, { cutoffHz: 3 });
    await step(module, 0, 0.3);
    for (let i = 0; i < 200; i++) {
      expect(await step(module, 7, 0.9)).toBeLessThanOrEqual(0.9);
    }
    for (let i = 0; i < 200; i++) {
      expect(await step(module, 70, 0.3)).toBeGreaterThanOrEqual(0.3);
    }
  });

  it('uses 1 Hz for a cut-off that is not finite', async () => {
    const wrong = await drive(lowPass);
    const right = await drive(lowPass);
    await wrong.run(0, { cutoffHz: NaN });
    await step(wrong, 0, 0);
    await step(right, 0, 0);
    expect(await step(wrong, 50, 1)).toBe(await step(right, 50, 1));
  });

  it('leaves NaN and infinity out, and gives their time to the next value', async () => {
    const broken = await drive(lowPass);
    const whole = await drive(lowPass);
    await step(broken, 0, 0);
    await step(whole, 0, 0);
    expect(await step(broken, 20, NaN)).toBeUndefined();
    expect(await step(broken, 20, -Infinity)).toBeUndefined();
    expect(await step(broken, 20, 1)).toBe(await step(whole, 60, 1));
  });

  it('does not become infinite between the ends of what a number can be', async () => {
    const module = await drive(lowPass);
    await step(module, 0, -1e150);
    expect(await step(module, 10, 1e150)).toBeLessThan(0);
    expect(await step(module, 10, Number.MAX_VALUE)).toBeUndefined();
    expect(await step(module, 1e9, 1)).toBeCloseTo(1, 12);
  });

  it('takes no second sample for a run that the cut-off caused', async () => {
    const module = await drive(lowPass);
    await step(module, 0, 0);
    expect(await module.run(50, { cutoffHz: 5 }, ['cutoffHz'])).toEqual({});
  });

  it('continues with the newest value in runs that nothing triggers', async () => {
    const module = await drive(lowPass);
    await module.run(0, { value: 0 });
    await module.run(1000, { value: 1 });
    expect((await module.run(60_000)).smoothed).toBe(1);
  });

  it('puts out a double for any number format [PM-31]', async () => {
    const module = await drive(lowPass);
    expect(await step(module, 0, new Sample(3, { type: 'int32' }))).toBe(3);
    expect(await step(module, 60_000, new Sample(0.5, { type: 'float' }))).toBe(0.5);
  });

  it.each([
    [lowPassVector2, { x: 1, y: -2 }],
    [lowPassVector3, { x: 1, y: -2, z: 3 }],
    [lowPassVector4, { x: 1, y: -2, z: 3, w: -4 }],
  ])('smooths each part of a vector as it would a number', async (definition, value) => {
    const module = await drive(definition);
    const number = await drive(lowPass);
    await step(number, 0, 0);
    const share = (await step(number, 30, 1)) as number;
    const parts = Object.entries(value);
    await step(module, 0, Object.fromEntries(parts.map(([name]) => [name, 0])));
    const smoothed = (await step(module, 30, value)) as { [part: string]: number };
    expect(Object.keys(smoothed)).toEqual(Object.keys(value));
    for (const [name, part] of parts) expect(smoothed[name]).toBeCloseTo(share * part, 12);
  });

  it('ignores a vector with a component that is not finite', async () => {
    const module = await drive(lowPassVector2);
    expect(await step(module, 0, { x: 0, y: NaN })).toBeUndefined();
    expect(await step(module, 0, { x: 0, y: 1 })).toEqual({ x: 0, y: 1 });
  });

  it('keeps rotations at length 1 and turns the shorter way', async () => {
    const module = await drive(lowPassQuaternion);
    expect(await step(module, 0, { x: 0, y: 0, z: 0, w: 2 })).toEqual({ x: 0, y: 0, z: 0, w: 1 });
    // A turn of 90 degrees around z, written with the other sign.
    const half = Math.SQRT1_2;
    const smoothed = (await step(module, 100, { x: 0, y: 0, z: -half, w: -half })) as {
      [part: string]: number;
    };
    expect(Math.hypot(...Object.values(smoothed))).toBeCloseTo(1, 12);
    expect(smoothed.z).toBeGreaterThan(0);
    expect(smoothed.w).toBeGreaterThan(half);
  });

  it('leaves a rotation of length 0 out', async () => {
    const module = await drive(lowPassQuaternion);
    expect(await step(module, 0, { x: 0, y: 0, z: 0, w: 0 })).toBeUndefined();
  });
});
