import { describe, expect, it } from 'vitest';
import { WAYS } from '../../test/ways.ts';
import { clock } from './clock.ts';

describe.each(WAYS)('clock %s', (_way, drive) => {
  it('starts at 0 with a tick', async () => {
    const module = await drive(clock);
    const outputs = await module.run(0);
    expect(outputs).toEqual({
      count: 0,
      elapsedMs: 0,
      tick: true,
      sine: 0,
      square: 1,
      triangle: 0,
      saw: -1,
    });
  });

  it('counts runs, adds up time and ticks once a turn', async () => {
    const module = await drive(clock);
    await module.run(0, { waveHz: 2 });
    expect(await module.run(200)).toMatchObject({ count: 1, elapsedMs: 200 });
    expect(await module.run(200)).not.toHaveProperty('tick');
    expect(await module.run(150)).toMatchObject({ count: 3, elapsedMs: 550, tick: true });
    expect(await module.run(200)).not.toHaveProperty('tick');
  });

  it.each([
    [0, { sine: 0, square: 1, triangle: 0, saw: -1 }],
    [250, { sine: 1, square: 1, triangle: 1, saw: -0.5 }],
    [500, { square: -1, triangle: 0, saw: 0 }],
    [750, { sine: -1, square: -1, triangle: -1, saw: 0.5 }],
  ])('has its waves right %d ms after the start', async (atMs, waves) => {
    const module = await drive(clock);
    await module.run(0);
    expect(await module.run(atMs)).toMatchObject(waves);
  });

  it('scales, moves and shifts the waves', async () => {
    const module = await drive(clock);
    const outputs = await module.run(0, { amplitude: 10, offset: 5, phase: 0.25, dutyCycle: 0.2 });
    expect(outputs).toMatchObject({ sine: 15, square: -5, triangle: 15, saw: 0 });
    expect(await module.run(0, { phase: -0.75 })).toMatchObject({ sine: 15 });
  });

  it('does not jump when the frequency changes', async () => {
    const module = await drive(clock);
    await module.run(0, { waveHz: 1 });
    await module.run(125);
    expect((await module.run(0, { waveHz: 100 })).saw).toBe(-0.75);
    expect((await module.run(0, { waveHz: 0 })).saw).toBe(-0.75);
    expect((await module.run(5000)).saw).toBe(-0.75);
  });

  it('keeps to its limits', async () => {
    const module = await drive(clock);
    await module.run(0, { waveHz: -5, dutyCycle: 7, amplitude: NaN, offset: Infinity });
    expect(await module.run(400)).toMatchObject({ sine: 0, square: 1, triangle: 0, saw: -1 });
  });

  it('ticks once after a gap of many turns, and goes on where it is', async () => {
    const module = await drive(clock);
    await module.run(0, { waveHz: 1 });
    expect(await module.run(3_600_250)).toMatchObject({ tick: true, saw: -0.5, count: 1 });
    expect(await module.run(100)).not.toHaveProperty('tick');
  });
});
