import type { Quaternion } from '@ubii/proto';
import { turnSince } from '../../devices/sensors/orientation.ts';

/** The identity rotation. */
export const STRAIGHT: Quaternion = { x: 0, y: 0, z: 0, w: 1 };

/** Rotates by `first`, then by `second`, about the axes of the world. */
export function turnBy(second: Quaternion, first: Quaternion): Quaternion {
  const { x, y, z, w } = second;
  return {
    x: w * first.x + x * first.w + y * first.z - z * first.y,
    y: w * first.y - x * first.z + y * first.w + z * first.x,
    z: w * first.z + x * first.y - y * first.x + z * first.w,
    w: w * first.w - x * first.x - y * first.y - z * first.z,
  };
}

/** Returns a rotation about a unit axis, radians. */
export function turnAbout([x, y, z]: readonly [number, number, number], angle: number): Quaternion {
  const sine = Math.sin(angle / 2);
  return { x: x * sine, y: y * sine, z: z * sine, w: Math.cos(angle / 2) };
}

/** Normalises a quaternion; undefined for a quaternion that is not a rotation. */
export function unitTurn({ x, y, z, w }: Quaternion): Quaternion | undefined {
  const length = Math.hypot(x, y, z, w);
  if (!(length > 1e-9) || !Number.isFinite(length)) return undefined;
  return { x: x / length, y: y / length, z: z / length, w: w / length };
}

/** Phones publish orientations with z up; on the screen, y is up and z points to the viewer. */
const TO_SCREEN = turnAbout([1, 0, 0], -Math.PI / 2);

/**
 * Returns the orientation of the model on the screen. Without `zero`, the model has the orientation of the
 * phone, with its top edge to the north. With `zero`, it has the rotation since `zero`.
 */
export function modelTurn(turn: Quaternion, zero: Quaternion | undefined): Quaternion {
  return zero ? turnSince(zero, turn) : turnBy(TO_SCREEN, turn);
}

/** Returns the angle of a rotation, degrees from 0 to 180. */
export function degreesOf({ x, y, z, w }: Quaternion): number {
  return (2 * Math.atan2(Math.hypot(x, y, z), Math.abs(w)) * 180) / Math.PI;
}
