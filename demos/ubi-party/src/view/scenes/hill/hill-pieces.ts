import { STEPS_PER_SECOND, type HillState, type Piece as HillPiece } from '../../../sim/index.ts';
import { clamp01, hop, mix, scatter, smooth } from '../../motion/motion.ts';
import type { Piece } from '../../pieces/piece.ts';
import type { Frame } from '../scene-view.ts';
import { PLATFORM_Y } from './platform-motion.ts';

/** Seconds from the edge to the table. */
const FALL_S = 0.85;
/** Seconds in which it comes to lie. */
const ROLL_S = 0.35;

/** A place on the table. */
interface Spot {
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

/** Larger than the disc it collides as: a token stands upright, and is seen from afar. */
const SCALE = 1.22;
/** Radians per unit per second: a piece leans into its motion. */
const LEAN = 0.026;
/** The token looks a little up. */
const TILT = -0.12;

const POSE: FallPose = { x: 0, y: 0, z: 0, roll: 0, pitch: 0 };

/** Moves a piece to where it is now. @returns the height of the ground below it, where it has one near */
export function placePiece(
  piece: Piece,
  one: HillPiece,
  state: HillState,
  step: number,
  frame: Frame,
): number | undefined {
  piece.root.scale.setScalar(SCALE);
  if (one.outAt !== undefined) return layDown(piece, one, one.outAt, state, step, frame);
  const aheadS = (step - state.step) / STEPS_PER_SECOND;
  const { position, velocity } = one;
  piece.root.position.set(
    position.x + velocity.x * aheadS,
    PLATFORM_Y,
    -(position.y + velocity.y * aheadS),
  );
  const isAnchored = one.power?.kind === 'anchor';
  const lean = isAnchored ? LEAN / 3 : LEAN;
  piece.settle(frame.dtS, -velocity.y * lean, -velocity.x * lean, frame.isReduced);
  // It crouches for the dash
  piece.body.scale.y *= 1 - 0.12 * one.charge;
  piece.root.rotation.set(0, 0, 0);
  turnToEye(piece, frame);
  return PLATFORM_Y;
}

function turnToEye(piece: Piece, { eye }: Frame): void {
  const { x, z } = piece.root.position;
  piece.token.rotation.set(TILT, Math.atan2(eye.x - x, eye.z - z), 0, 'YXZ');
}

function layDown(
  piece: Piece,
  one: HillPiece,
  outAt: number,
  state: HillState,
  step: number,
  frame: Frame,
): number | undefined {
  const sinceS = Math.max(0, (step - outAt) / STEPS_PER_SECOND);
  const isRight = one.position.x >= 0;
  const from = { x: one.position.x, z: -one.position.y };
  const to = lyingSpot(isRight, orderOf(one, outAt, isRight, state));
  const pose = fallPose(from, to, sinceS, piece.halfWidth * SCALE, frame.isReduced, POSE);
  piece.settle(frame.dtS, 0, 0, true);
  piece.root.position.set(pose.x, pose.y, pose.z);
  piece.root.rotation.set(pose.pitch, 0, pose.roll);
  turnToEye(piece, frame);
  return sinceS > 0.6 ? 0 : undefined;
}

/** Number of pieces that fell to the same side before. */
function orderOf(one: HillPiece, outAt: number, isRight: boolean, state: HillState): number {
  let order = 0;
  for (const other of state.pieces) {
    if (other.outAt === undefined || other.position.x >= 0 !== isRight) continue;
    if (other.outAt < outAt || (other.outAt === outAt && other.seat < one.seat)) order += 1;
  }
  return order;
}
