import { clamp01 } from '../../motion/motion.ts';

/** Position of a cart on the table, units; z grows towards the camera. */
export interface CrowdSpot {
  readonly x: number;
  readonly z: number;
  /** The crown stands on its token. */
  readonly isCrowned?: boolean;
}

/** Position of a token above its cart that keeps its letter visible. */
export interface CrowdStand {
  /** Share of its full size. */
  readonly size: number;
  /** On a mast, units above the cart. */
  readonly lift: number;
}

/** A token of full size, units. */
const WIDTH = 5.2;
const HEIGHT = 5.4;
const MIN_SIZE = 0.6;
const MAX_LIFT = 6;
/** The camera looks down 36 degrees: a unit towards it lowers the picture as much as this share of a unit of height. */
const DEPTH_TO_HEIGHT = 0.73;
/** Extent of the letter on a token, and the part of its square that the token fills. Shares of its size. */
const LETTER_HALF = 0.25;
const LETTER_FOOT = 0.25;
const TOKEN_HALF = 0.42;
const TOP = 0.95;
const CROWNED_TOP = 1.4;
/** Share of the width over which a token that comes beside another is lifted: none jumps. */
const SOFT = 0.12;

/** Tokens that would hide each other are smaller, and those behind stand on masts. In the order of the spots. */
export function standInCrowd(spots: readonly CrowdSpot[]): CrowdStand[] {
  const sizes = spots.map((spot, index) => sizeAmong(spot, index, spots));
  const lifts = spots.map(() => 0);
  const fromFront = spots.map((_, index) => index).sort((a, b) => spots[b]!.z - spots[a]!.z);
  for (const [order, index] of fromFront.entries()) {
    const [spot, size] = [spots[index]!, sizes[index]!];
    for (const front of fromFront.slice(0, order)) {
      const before = spots[front]!;
      const beside = WIDTH * (LETTER_HALF * size + TOKEN_HALF * sizes[front]!);
      const covers = beside - Math.abs(before.x - spot.x);
      if (covers <= 0) continue;
      const share = clamp01(covers / (WIDTH * size * SOFT));
      const seen = (before.z - spot.z) * DEPTH_TO_HEIGHT + lifts[index]! - lifts[front]!;
      const top = before.isCrowned ? CROWNED_TOP : TOP;
      const needed = HEIGHT * (top * sizes[front]! - LETTER_FOOT * size);
      lifts[index]! += Math.max(0, (needed - seen) * share);
    }
    lifts[index] = Math.min(MAX_LIFT, lifts[index]!);
  }
  return spots.map((_, index) => ({ size: sizes[index]!, lift: lifts[index]! }));
}

/** The more tokens are within its width, the smaller it is. */
function sizeAmong(spot: CrowdSpot, index: number, spots: readonly CrowdSpot[]): number {
  let crowd = 0;
  for (const [other, { x, z }] of spots.entries()) {
    if (other === index) continue;
    crowd += clamp01(1.4 - Math.hypot(x - spot.x, (z - spot.z) * DEPTH_TO_HEIGHT) / WIDTH);
  }
  return Math.max(MIN_SIZE, 1 / (1 + 0.11 * crowd));
}
