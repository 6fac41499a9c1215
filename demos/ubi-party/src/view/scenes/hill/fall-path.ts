import { clamp01, hop, mix, scatter, smooth } from '../../motion/ease.ts';
import { PLATFORM_Y } from './platform-motion.ts';

/** Seconds from the edge to the table. */
const FALL_S = 0.85;
/** Seconds in which it comes to lie. */
const ROLL_S = 0.35;

/** A place on the table. */
export interface Spot {
  readonly x: number;
  readonly z: number;
}

const ROWS = 5;
const ROW = 3.1;
/** The first column at each side, and from one to the next, units from the middle. */
const COLUMN = { first: 12.4, next: 3 } as const;

/**
 * Position of a fallen piece: at the left or the right of the hill, near ones first, never under it. @param order among
 * those at that side
 */
export function lyingSpot(isRight: boolean, order: number): Spot {
  const column = Math.floor(order / ROWS);
  const row = order % ROWS;
  // From a little before the middle, alternately away and towards
  const z = -0.5 + (row % 2 === 0 ? -1 : 1) * Math.ceil(row / 2) * ROW;
  const x = COLUMN.first + column * COLUMN.next + (scatter(order, isRight ? 1 : 2) - 0.5) * 0.5;
  return { x: isRight ? x : -x, z };
}

/** Pose of a falling piece. */
export interface FallPose {
  x: number;
  y: number;
  z: number;
  /** About the line of sight: a quarter turn is on its side. */
  roll: number;
  /** Forward over the edge. */
  pitch: number;
}

/**
 * From the edge in an arc to where it lies; on the table it rolls onto its side.
 *
 * @param rest height of its axis when it lies, units
 */
export function fallPose(
  from: Spot,
  to: Spot,
  sinceS: number,
  rest: number,
  isReduced: boolean,
  into: FallPose,
): FallPose {
  const share = isReduced ? Number(sinceS > 0.2) : clamp01(sinceS / FALL_S);
  const side = to.x > from.x ? -1 : 1;
  const rolled = smooth((sinceS - FALL_S) / ROLL_S);
  into.x = mix(from.x, to.x, share);
  into.z = mix(from.z, to.z, share);
  into.y = (1 - share * share) * PLATFORM_Y + hop(share) * 0.9 + hop((sinceS - FALL_S) / 0.3) * 0.5;
  into.roll = side * (share * 1.1 + (isReduced ? 1 : rolled) * (Math.PI / 2 - 1.1 + 0.08));
  into.pitch = Math.sin(share * Math.PI) * 0.5;
  into.y += Math.abs(Math.sin(into.roll)) * rest * share;
  return into;
}
