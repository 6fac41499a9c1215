import { describe, expect, it } from 'vitest';
import { RINGS } from '../../../sim/index.ts';
import { fallPose, lyingSpot, type FallPose } from './hill-pieces.ts';
import { BLOCKS, blockPose, dangerOf, PLATFORM_Y, type BlockPose } from './platform-motion.ts';

const POSE: BlockPose = { out: 0, up: 0, tilt: 0, turn: 0, down: 0 };
const at = (ring: number, block: number, step: number, isReduced = false): BlockPose => ({
  ...blockPose(ring, block, step, isReduced, POSE),
});

describe('blocks of the platform', () => {
  it('are still until a second before their ring falls, then tremble', () => {
    for (const [ring, { fallsAt }] of RINGS.entries()) {
      expect(at(ring, 3, fallsAt - 61)).toEqual({ out: 0, up: 0, tilt: 0, turn: 0, down: 0 });
      const trembling = Array.from({ length: 30 }, (_, step) => at(ring, 3, fallsAt - 40 + step));
      expect(Math.max(...trembling.map(({ up }) => Math.abs(up)))).toBeGreaterThan(0.01);
      expect(Math.max(...trembling.map(({ up }) => Math.abs(up)))).toBeLessThan(0.06);
    }
  });

  it('lie on the table two seconds later, and not below it', () => {
    for (const [ring, { fallsAt }] of RINGS.entries()) {
      for (let block = 0; block < BLOCKS[ring]!; block += 1) {
        const { up, down } = at(ring, block, fallsAt + 120);
        expect(down).toBe(1);
        expect(up).toBeGreaterThan(-PLATFORM_Y);
      }
    }
  });

  it('sink without trembling or tumbling with reduced motion', () => {
    const { fallsAt } = RINGS[0]!;
    expect(at(0, 5, fallsAt - 20, true).up).toBe(0);
    expect(at(0, 5, fallsAt + 120, true)).toMatchObject({ tilt: 0, turn: 0, out: 0, down: 1 });
  });

  it('have the colour of danger when they are next', () => {
    expect(dangerOf(1, RINGS[0]!.fallsAt - 1)).toBe(0);
    expect(dangerOf(1, RINGS[0]!.fallsAt + 120)).toBe(1);
    expect(dangerOf(3, RINGS[1]!.fallsAt)).toBe(0);
  });
});

describe('fall path', () => {
  const pose: FallPose = { x: 0, y: 0, z: 0, roll: 0, pitch: 0 };

  it('leads from the edge of the platform to the spot on the table', () => {
    const to = lyingSpot(true, 0);
    expect(fallPose({ x: 9, z: 4 }, to, 0, 0.9, false, pose)).toMatchObject({
      x: 9,
      y: PLATFORM_Y,
      z: 4,
    });
    const end = fallPose({ x: 9, z: 4 }, to, 5, 0.9, false, pose);
    expect(end).toMatchObject({ x: to.x, z: to.z });
    expect(end.y).toBeLessThan(1);
    expect(Math.abs(end.roll)).toBeGreaterThan(1.5);
  });

  it('gives 16 at each side their own spot beside the hill', () => {
    const spots = Array.from({ length: 16 }, (_, order) => lyingSpot(false, order));
    for (const [index, a] of spots.entries()) {
      expect(Math.hypot(a.x, a.z)).toBeGreaterThan(11.5);
      for (const b of spots.slice(index + 1)) {
        expect(Math.hypot(a.x - b.x, a.z - b.z)).toBeGreaterThan(1.5);
      }
    }
  });
});
