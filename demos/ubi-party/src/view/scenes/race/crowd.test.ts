import { describe, expect, it } from 'vitest';
import { raceGame } from '../../../sim/race/race-game.ts';
import { playWithBots } from '../../../sim/testing/play-with-bots.ts';
import { standInCrowd, type CrowdSpot } from './crowd.ts';

/** Of a token of full size, units; the picture as `crowd.ts` has it. */
const [WIDTH, HEIGHT, DEPTH_TO_HEIGHT] = [5.2, 5.4, 0.73];

/** Number of tokens that hide the middle of another one's letter, or a corner of it. */
function hiddenLetters(spots: readonly CrowdSpot[]): number {
  const tokens = standInCrowd(spots).map(({ size, lift }, index) => {
    const { x, z } = spots[index]!;
    return { x, z, size, foot: lift - z * DEPTH_TO_HEIGHT };
  });
  const isHidden = (x: number, y: number, z: number): boolean =>
    tokens.some((front) => {
      const up = (y - front.foot) / (HEIGHT * front.size);
      return front.z > z && Math.abs(front.x - x) < 0.4 * WIDTH * front.size && up > 0 && up < 0.9;
    });
  return tokens.filter(({ x, z, size, foot }) =>
    [-0.15, 0, 0.15].some((aside) =>
      [0.3, 0.48, 0.65].some((up) =>
        isHidden(x + aside * WIDTH * size, foot + up * HEIGHT * size, z),
      ),
    ),
  ).length;
}

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

  it('the one behind the crown stands higher', () => {
    const behind = (isCrowned: boolean): number =>
      standInCrowd([
        { x: 0.3, z: -2 },
        { x: 0, z: 0, isCrowned },
      ])[0]!.lift;
    expect(behind(true)).toBeGreaterThan(behind(false) + 1);
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

  it.each([0, 1, 2])('nearly all letters are seen in a race of 16 on track %i', (seed) => {
    let [hidden, all] = [0, 0];
    playWithBots(raceGame, 16, seed, ({ step, carts }) => {
      if (step % 60 !== 0) return;
      hidden += hiddenLetters(carts.map(({ position: { x, y } }) => ({ x, z: -y })));
      all += carts.length;
    });
    expect(hidden / all).toBeLessThan(0.03);
  });
});
