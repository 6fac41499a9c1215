import { describe, expect, it } from 'vitest';
import type { DrivenModule } from '../../test/drive-module.ts';
import { WAYS } from '../../test/ways.ts';
import {
  oneEuroFilter,
  oneEuroFilterQuaternion,
  oneEuroFilterVector2,
  oneEuroFilterVector3,
  oneEuroFilterVector4,
} from './one-euro-filter.ts';

const RATE_HZ = 60;
const INTERVAL_MS = 1000 / RATE_HZ;

async function step(module: DrivenModule, deltaTimeMs: number, value: unknown): Promise<unknown> {
  return (await module.run(deltaTimeMs, { value }, ['value'])).smoothed;
}

/** Algorithm 1 of the paper, word for word, for one number at a fixed rate. */
function paperFilter(minCutoffHz: number, beta: number, derivativeCutoffHz: number) {
  const alpha = (cutoffHz: number): number => {
    const tau = 1 / (2 * Math.PI * cutoffHz);
    const te = 1 / RATE_HZ;
    return 1 / (1 + tau / te);
  };
  let previous: { x: number; dx: number } | undefined;
  return (x: number): number => {
    if (previous === undefined) {
      previous = { x, dx: 0 };
      return x;
    }
    const dx = (x - previous.x) * RATE_HZ;
    const a = alpha(derivativeCutoffHz);
    const edx = a * dx + (1 - a) * previous.dx;
    const b = alpha(minCutoffHz + beta * Math.abs(edx));
    previous = { x: b * x + (1 - b) * previous.x, dx: edx };
    return previous.x;
  };
}

describe.each(WAYS)('one-euro-filter %s', (_way, drive) => {
  it('does what the paper says', async () => {
    const module = await drive(oneEuroFilter);
    const paper = paperFilter(0.5, 0.02, 2);
    await module.run(0, { minCutoffHz: 0.5, beta: 0.02, derivativeCutoffHz: 2 });
    for (let i = 0; i < 100; i++) {
      const value = 10 * Math.sin(i / 9) + Math.sin(i * 7.3);
      const smoothed = await step(module, i === 0 ? 0 : INTERVAL_MS, value);
      expect(smoothed).toBeCloseTo(paper(value), 9);
    }
  });

  it('lags less when it is fast, and shakes less than what came in when it is slow', async () => {
    const module = await drive(oneEuroFilter);
    await module.run(0, { beta: 10 });
    const shaken: number[] = [];
    for (let i = 0; i < 60; i++) {
      shaken.push((await step(module, INTERVAL_MS, 0.001 * (-1) ** i)) as number);
    }
    expect(Math.max(...shaken.slice(30).map(Math.abs))).toBeLessThan(0.0005);
    let smoothed: unknown;
    for (let i = 0; i < 30; i++) smoothed = await step(module, INTERVAL_MS, i);
    expect(smoothed).toBeGreaterThan(28.9);
  });

  it('is a plain low-pass with beta 0', async () => {
    const module = await drive(oneEuroFilter);
    await module.run(0, { beta: 0, minCutoffHz: 1 });
    await step(module, 0, 0);
    const turns = 2 * Math.PI * 0.1;
    expect(await step(module, 100, 1)).toBeCloseTo(turns / (1 + turns), 12);
  });

  it('waits when no time has passed', async () => {
    const module = await drive(oneEuroFilter);
    expect(await step(module, 0, 1)).toBe(1);
    expect(await step(module, 0, 100)).toBe(1);
    expect(await step(module, INTERVAL_MS, 1)).toBe(1);
  });

  it('leaves NaN out, and gives its time to the next value', async () => {
    const broken = await drive(oneEuroFilter);
    const whole = await drive(oneEuroFilter);
    await step(broken, 0, 0);
    await step(whole, 0, 0);
    expect(await step(broken, 20, NaN)).toBeUndefined();
    expect(await step(broken, 20, 1)).toBe(await step(whole, 40, 1));
  });

  it('is near the new value after a long gap', async () => {
    const module = await drive(oneEuroFilter);
    await step(module, 0, 0);
    expect(await step(module, 3_600_000, 5)).toBeCloseTo(5, 2);
  });

  it('clamps parameters, and uses defaults for those that are not finite', async () => {
    const wrong = await drive(oneEuroFilter);
    const right = await drive(oneEuroFilter);
    await wrong.run(0, { minCutoffHz: -1, beta: NaN, derivativeCutoffHz: Infinity });
    await right.run(0, { minCutoffHz: 0, beta: 1, derivativeCutoffHz: 1 });
    for (const value of [0, 1, 5]) {
      expect(await step(wrong, 20, value)).toBe(await step(right, 20, value));
    }
  });

  it('stays finite from one end of what a number can be to the other', async () => {
    const module = await drive(oneEuroFilter);
    await module.run(0, { beta: 1e9 });
    await step(module, 0, -1e150);
    expect(await step(module, 0.001, 1e150)).toBeCloseTo(1e150, -140);
    expect(await step(module, 1000, 1)).toEqual(expect.any(Number));
  });

  it.each([
    [oneEuroFilterVector2, ['x', 'y']],
    [oneEuroFilterVector3, ['x', 'y', 'z']],
    [oneEuroFilterVector4, ['x', 'y', 'z', 'w']],
  ])('treats a movement alike in any direction', async (definition, names) => {
    const along = await drive(definition);
    const across = await drive(definition);
    const zero = Object.fromEntries(names.map((name) => [name, 0]));
    await step(along, 0, zero);
    await step(across, 0, zero);
    const straight = (await step(along, 20, { ...zero, x: 1 })) as { [part: string]: number };
    const each = 1 / Math.sqrt(names.length);
    const diagonal = (await step(
      across,
      20,
      Object.fromEntries(names.map((name) => [name, each])),
    )) as { [part: string]: number };
    expect(Math.hypot(...Object.values(diagonal))).toBeCloseTo(straight.x!, 12);
  });

  it('takes the speed of a rotation in radians per second', async () => {
    const rotation = await drive(oneEuroFilterQuaternion);
    const slow = { beta: 0, derivativeCutoffHz: 1000 };
    await rotation.run(0, slow);
    const angle = 0.001;
    await step(rotation, 0, { x: 0, y: 0, z: 0, w: 1 });
    await rotation.run(0, { ...slow, beta: 1000 }, ['beta']);
    const turned = { x: 0, y: 0, z: Math.sin(angle / 2), w: Math.cos(angle / 2) };
    const smoothed = (await step(rotation, 10, turned)) as { z: number };

    const number = await drive(oneEuroFilter);
    await number.run(0, { ...slow, beta: 1000 });
    await step(number, 0, 0);
    expect((2 * Math.asin(smoothed.z)) / angle).toBeCloseTo(
      ((await step(number, 10, angle)) as number) / angle,
      4,
    );
  });

  it('turns the shorter way and leaves rotations of length 0 out', async () => {
    const module = await drive(oneEuroFilterQuaternion);
    await step(module, 0, { x: 0, y: 0, z: 0, w: 1 });
    expect(await step(module, 20, { x: 0, y: 0, z: 0, w: 0 })).toBeUndefined();
    expect(await step(module, 20, { x: 0, y: 0, z: 0, w: -1 })).toEqual({ x: 0, y: 0, z: 0, w: 1 });
  });
});
