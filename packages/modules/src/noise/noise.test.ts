import { describe, expect, it } from 'vitest';
import type { Drive } from '../../test/drive-module.ts';
import { WAYS } from '../../test/ways.ts';
import { noise } from './noise.ts';

interface Values {
  uniform: number;
  normal: number;
  walk: number;
}

async function play(drive: Drive, runs: number, inputs = {}): Promise<Values[]> {
  const module = await drive(noise);
  const values: Values[] = [];
  for (let run = 0; run < runs; run += 1) {
    values.push((await module.run(20, inputs)) as unknown as Values);
  }
  return values;
}

const mean = (numbers: readonly number[]): number =>
  numbers.reduce((sum, number) => sum + number, 0) / numbers.length;

describe.each(WAYS)('noise %s', (_way, drive) => {
  it('has the distributions it names', async () => {
    const values = await play(drive, 600);
    const uniform = values.map((value) => value.uniform);
    expect(Math.abs(mean(uniform))).toBeLessThan(0.1);
    expect(mean(uniform.map((value) => value ** 2))).toBeCloseTo(1 / 3, 1);
    expect(Math.max(...uniform.map(Math.abs))).toBeLessThanOrEqual(1);
    const normal = values.map((value) => value.normal);
    expect(Math.abs(mean(normal))).toBeLessThan(0.15);
    expect(Math.abs(mean(normal.map((value) => value ** 2)) - 1)).toBeLessThan(0.2);
  });

  it('walks in small steps and stays in range', async () => {
    const walk = (await play(drive, 300)).map((value) => value.walk);
    expect(Math.max(...walk.map(Math.abs))).toBeLessThanOrEqual(1);
    const steps = walk.slice(1).map((value, index) => Math.abs(value - walk[index]!));
    expect(Math.max(...steps)).toBeLessThan(0.8);
    expect(new Set(walk).size).toBeGreaterThan(250);
  });

  it('repeats itself with the same seed, and starts again with a new one', async () => {
    expect(await play(drive, 5, { seed: 7 })).toEqual(await play(drive, 5, { seed: 7 }));
    expect(await play(drive, 5, { seed: 7 })).not.toEqual(await play(drive, 5, { seed: 8 }));
    const module = await drive(noise);
    const first = await module.run(20, { seed: 3 });
    await module.run(20);
    await module.run(20, { seed: 4 });
    expect(await module.run(20, { seed: 3 })).toEqual(first);
  });

  it('scales with amplitude and offset', async () => {
    const values = await play(drive, 50, { amplitude: 0, offset: 5 });
    expect(new Set(values.flatMap((value) => Object.values(value)))).toEqual(new Set([5]));
  });
});
