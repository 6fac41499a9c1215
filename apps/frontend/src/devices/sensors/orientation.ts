import type { Quaternion, Vector3 } from '@ubii/proto';

/**
 * Orientation of a device as browsers report it: rotations about its z, x and y axis in degrees, in this order.
 * https://www.w3.org/TR/orientation-event/#deviceorientation
 */
export interface EulerAngles {
  /** About z, 0 to 360. */
  readonly alpha: number;
  /** About x, −180 to 180. */
  readonly beta: number;
  /** About y, −90 to 90. */
  readonly gamma: number;
}

/** The same rotation as a unit quaternion: about z, then the rotated x, then the rotated y. */
export function quaternionOf({ alpha, beta, gamma }: EulerAngles): Quaternion {
  const half = Math.PI / 360;
  const [cx, sx] = [Math.cos(beta * half), Math.sin(beta * half)];
  const [cy, sy] = [Math.cos(gamma * half), Math.sin(gamma * half)];
  const [cz, sz] = [Math.cos(alpha * half), Math.sin(alpha * half)];
  return {
    x: cz * sx * cy - sz * cx * sy,
    y: cz * cx * sy + sz * sx * cy,
    z: sz * cx * cy + cz * sx * sy,
    w: cz * cx * cy - sz * sx * sy,
  };
}

/** Rotation from `reference` to `now`, in the coordinates of the device at `reference`. */
export function turnSince(reference: Quaternion, now: Quaternion): Quaternion {
  const { x, y, z, w } = reference;
  // conjugate(reference) * now
  return {
    x: w * now.x - x * now.w - y * now.z + z * now.y,
    y: w * now.y + x * now.z - y * now.w - z * now.x,
    z: w * now.z - x * now.y + y * now.x - z * now.w,
    w: w * now.w + x * now.x + y * now.y + z * now.z,
  };
}

/**
 * Angles minus those of the calibration, per axis, as existing programs expect them: x, y, z are alpha, beta and gamma,
 * degrees from −180 to 180, or from 0 to 360 for alpha without a calibration.
 */
export function calibratedAngles(now: EulerAngles, zero: EulerAngles | undefined): Vector3 {
  if (zero === undefined) return { x: now.alpha, y: now.beta, z: now.gamma };
  return {
    x: shortest(now.alpha - zero.alpha),
    y: shortest(now.beta - zero.beta),
    z: shortest(now.gamma - zero.gamma),
  };
}

/** Normalises an angle to −180 to 180 degrees. */
function shortest(degrees: number): number {
  const turned = (((degrees + 180) % 360) + 360) % 360;
  return turned - 180;
}
