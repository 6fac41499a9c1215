import { describe, expect, it } from 'vitest';
import { WAYS } from '../../test/ways.ts';
import { positionColor } from './position-color.ts';

describe.each(WAYS)('position-color %s', (_way, drive) => {
  it('goes around the hues from left to right', async () => {
    const module = await drive(positionColor);
    const at = async (x: number) =>
      (await module.run(0, { position: { x, y: 0.538_461_5 }, saturation: 1 })).hex;
    expect(await at(0)).toBe('#ff0000');
    expect(await at(1 / 3)).toBe('#00ff00');
    expect(await at(2 / 3)).toBe('#0000ff');
    expect(await at(1)).toBe('#ff0000');
  });

  it('is light at the top and dark at the bottom', async () => {
    const module = await drive(positionColor);
    const grey = async (y: number) =>
      (await module.run(0, { position: { x: 0.2, y }, saturation: 0 })).color as { r: number };
    expect((await grey(0)).r).toBeCloseTo(0.85);
    expect((await grey(1)).r).toBeCloseTo(0.2);
    expect((await grey(5)).r).toBeCloseTo(0.2);
  });

  it('puts out nothing without a position', async () => {
    const module = await drive(positionColor);
    expect(await module.run(0)).toEqual({});
    expect(await module.run(0, { position: { x: NaN, y: 0 } })).toEqual({});
  });
});
