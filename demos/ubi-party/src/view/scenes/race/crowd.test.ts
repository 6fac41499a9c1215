import { describe, expect, it } from 'vitest';
import { standInCrowd } from './crowd.ts';

describe('tokens in a crowd', () => {
  it('a cart alone has a token of full size, on the cart', () => {
    expect(standInCrowd([{ x: 0, z: 0 }])).toEqual([{ size: 1, lift: 0 }]);
    expect(
      standInCrowd([
        { x: -20, z: 0 },
        { x: 20, z: 0 },
      ]),
    ).toEqual([
      { size: 1, lift: 0 },
      { size: 1, lift: 0 },
    ]);
  });

  it('the one behind stands on a mast, the one in front does not', () => {
    const [behind, front] = standInCrowd([
      { x: 0.3, z: -2 },
      { x: 0, z: 0 },
    ]);
    expect(front!.lift).toBe(0);
    expect(behind!.lift).toBeGreaterThan(1);
    expect(behind!.size).toBeLessThan(1);
  });

  it('a bunch shrinks no further than letters can be read, and masts have an end', () => {
    const bunch = Array.from({ length: 32 }, (_, index) => ({
      x: index % 2,
      z: -Math.floor(index / 2) * 0.5,
    }));
    for (const { size, lift } of standInCrowd(bunch)) {
      expect(size).toBeGreaterThanOrEqual(0.6);
      expect(lift).toBeLessThanOrEqual(6);
    }
  });
});
