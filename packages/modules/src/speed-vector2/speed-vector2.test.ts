import { describe, expect, it } from 'vitest';
import { WAYS } from '../../test/ways.ts';
import { speedVector2 } from './speed-vector2.ts';

describe.each(WAYS)('speed-vector2 %s', (_way, drive) => {
  it('gives velocity, speed and distance per second, without smoothing', async () => {
    const module = await drive(speedVector2);
    expect(await module.run(0, { position: { x: 0, y: 0 }, smoothingMs: 0 })).toEqual({
      velocity: { x: 0, y: 0 },
      speed: 0,
      distance: 0,
    });
    expect(await module.run(250, { position: { x: 0.75, y: 1 } })).toEqual({
      velocity: { x: 3, y: 4 },
      speed: 5,
      distance: 1.25,
    });
  });

  it('goes down to 0 while no new position arrives', async () => {
    const module = await drive(speedVector2);
    await module.run(0, { position: { x: 0, y: 0 } });
    const moving = (await module.run(33, { position: { x: 0.1, y: 0 } })) as { speed: number };
    let still = moving;
    for (let run = 0; run < 30; run += 1) still = (await module.run(33)) as { speed: number };
    expect(moving.speed).toBeGreaterThan(1);
    expect(still.speed).toBeLessThan(0.001);
  });

  it('leaves out what is not a position, and gives its time to the next one', async () => {
    const module = await drive(speedVector2);
    await module.run(0, { position: { x: 0, y: 0 }, smoothingMs: 0 });
    expect(await module.run(100, { position: { x: NaN, y: 0 } })).toEqual({});
    expect(await module.run(100, { position: { x: 1, y: 0 } })).toMatchObject({ speed: 5 });
  });

  it('ignores a run that only a parameter caused', async () => {
    const module = await drive(speedVector2);
    await module.run(0, { position: { x: 0, y: 0 } }, ['position']);
    expect(await module.run(10, { smoothingMs: 10 }, ['smoothingMs'])).toEqual({});
  });
});
