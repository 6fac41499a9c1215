import { RINGS, STEPS_PER_SECOND } from '../../../sim/index.ts';
import { clamp01, scatter } from '../../motion/motion.ts';

/** Height of the platform above the table, units. */
export const PLATFORM_Y = 3.4;
/** Of the blocks of a ring. */
export const BLOCK_HEIGHT = 0.7;
/** Of the drum below it: what falls, falls beside it. */
export const DRUM_RADIUS = 7.6;
/** Blocks of each ring, from the outside in. */
export const BLOCKS = [18, 16, 12, 10] as const;
/** Seconds before a ring falls in which it trembles. */
const TREMBLE_S = 1;
/** Seconds before, in which it takes the colour of danger. */
const WARN_S = 3;
const GRAVITY = 26;
/** Rest of a block that lies on the table: height of its middle. */
const REST_Y = 0.36;

/** Pose of a block of a ring, relative to its place in the platform. */
export interface BlockPose {
  /** Outwards, and up, units. */
  out: number;
  up: number;
  /** Outwards over the edge, radians; and about its own middle. */
  tilt: number;
  turn: number;
  /** 0 in the platform, 1 lying on the table. */
  down: number;
}

/** Of a block of a ring at a time. Trembles for a second, tilts, then falls; each block a little later than others. */
export function blockPose(
  ring: number,
  block: number,
  step: number,
  isReduced: boolean,
  into: BlockPose,
): BlockPose {
  const sinceS = (step - RINGS[ring]!.fallsAt) / STEPS_PER_SECOND;
  into.out = into.up = into.tilt = into.turn = into.down = 0;
  if (sinceS < -TREMBLE_S) return into;
  const delayS = scatter(block, ring) * 0.3;
  if (sinceS < delayS) {
    if (isReduced) return into;
    const strength = 0.3 + 0.7 * clamp01(1 + sinceS);
    into.up = Math.sin(sinceS * 71 + block * 2.4) * 0.05 * strength;
    into.tilt = Math.sin(sinceS * 58 + block * 1.7) * 0.025 * strength;
    return into;
  }
  const fallS = sinceS - delayS;
  const depth = PLATFORM_Y - BLOCK_HEIGHT / 2 - REST_Y;
  // A block tilts over its inner edge for a moment, then it falls freely
  const freeS = Math.max(0, fallS - 0.14);
  const landS = Math.sqrt((2 * depth) / GRAVITY);
  into.down = clamp01(freeS / landS);
  into.up = -Math.min(depth, (GRAVITY * freeS * freeS) / 2);
  if (isReduced) return into;
  const spread = 0.7 + scatter(block, ring + 20);
  into.out = 0.25 * clamp01(fallS / 0.14) + into.down * (spread * 1.2 + restOut(ring));
  const tilted = 0.35 * clamp01(fallS / 0.14) + into.down * (0.6 + scatter(block, ring + 30));
  // It lands on a flat side, nearly
  const settled =
    Math.round(scatter(block, ring + 40)) * Math.PI + (scatter(block, 3) - 0.5) * 0.24;
  into.tilt =
    into.down < 1
      ? tilted
      : settled * clamp01((freeS - landS) / 0.12) + tilted * (1 - clamp01((freeS - landS) / 0.12));
  into.turn = into.down * (scatter(block, ring + 50) - 0.5) * 1.6;
  return into;
}

/** Units outwards to the ground beside the drum. */
function restOut(ring: number): number {
  return Math.max(0, DRUM_RADIUS + 0.6 - RINGS[ring]!.inner);
}

/**
 * Share of the danger colour on a ring, 0 to 1. The outer ring always has it; the others from when the one before them
 * has fallen.
 */
export function dangerOf(ring: number, step: number): number {
  if (ring === 0) return 1;
  const before = RINGS[ring - 1]!.fallsAt;
  const soonS = (step - (RINGS[ring]!.fallsAt - WARN_S * STEPS_PER_SECOND)) / STEPS_PER_SECOND;
  return Math.max(clamp01((step - before) / STEPS_PER_SECOND - 0.4), clamp01(soonS));
}
