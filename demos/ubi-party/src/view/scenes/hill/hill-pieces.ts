import { STEPS_PER_SECOND, type HillState, type Piece as HillPiece } from '../../../sim/index.ts';
import type { Piece } from '../../pieces/piece.ts';
import type { Frame } from '../scene-view.ts';
import { fallPose, lyingSpot, type FallPose } from './fall-path.ts';
import { PLATFORM_Y } from './platform-motion.ts';

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
