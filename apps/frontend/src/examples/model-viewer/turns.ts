import type { Quaternion } from '@ubii/proto';
import { turnSince } from '../../devices/sensors/orientation.ts';

/** No turn at all. */
export const STRAIGHT: Quaternion = { x: 0, y: 0, z: 0, w: 1 };

/** `first`, then `second`, about the axes of the world. */
export function turnBy(second: Quaternion, first: Quaternion): Quaternion {
  const { x, y, z, w } = second;
  return {
    x: w * first.x + x * first.w + y * first.z - z * first.y,
    y: w * first.y - x * first.z + y * first.w + z * first.x,
    z: w * first.z + x * first.y - y * first.x + z * first.w,
    w: w * first.w - x * first.x - y * first.y - z * first.z,
  };
}

/** A turn about an axis of length 1, radians. */
export function turnAbout([x, y, z]: readonly [number, number, number], angle: number): Quaternion {
  const sine = Math.sin(angle / 2);
  return { x: x * sine, y: y * sine, z: z * sine, w: Math.cos(angle / 2) };
}

/** A unit quaternion, undefined for what is no turn. */
export function unitTurn({ x, y, z, w }: Quaternion): Quaternion | undefined {
  const length = Math.hypot(x, y, z, w);
  if (!(length > 1e-9) || !Number.isFinite(length)) return undefined;
  return { x: x / length, y: y / length, z: z / length, w: w / length };
}

/** A phone tells its turn with z up; on the screen y is up and z comes out of it. */
const TO_SCREEN = turnAbout([1, 0, 0], -Math.PI / 2);

/**
 * How the model lies on the screen. Before a zero it lies as the phone does, its top edge northwards;
 * after it the model faces the viewer as long as the phone is held as it was.
 */
export function modelTurn(turn: Quaternion, zero: Quaternion | undefined): Quaternion {
  return zero ? turnSince(zero, turn) : turnBy(TO_SCREEN, turn);
}

/** How far a turn goes altogether, degrees from 0 to 180. */
export function degreesOf({ x, y, z, w }: Quaternion): number {
  return (2 * Math.atan2(Math.hypot(x, y, z), Math.abs(w)) * 180) / Math.PI;
}
