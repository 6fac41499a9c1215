/** A unit quaternion. */
export interface Rotation {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly w: number;
}

/** Rotations about the axes in degrees, applied in the order z, y, x of the rotated body. */
export interface Angles {
  /** About z. */
  readonly yaw: number;
  /** About y. */
  readonly pitch: number;
  /** About x. */
  readonly roll: number;
}

const RADIANS = Math.PI / 180;
const rounded = (value: number): number => Number(value.toFixed(6)) || 0;

/** Normalises a quaternion; the identity for an invalid one. */
export function normalized({ x, y, z, w }: Rotation): Rotation {
  const length = Math.hypot(x, y, z, w);
  if (!(length > 0) || !Number.isFinite(length)) return { x: 0, y: 0, z: 0, w: 1 };
  return { x: x / length, y: y / length, z: z / length, w: w / length };
}

/** Rotates by `first`, then by `second` about the axes of the world. */
export function turned(first: Rotation, second: Rotation): Rotation {
  const { x: a, y: b, z: c, w: d } = second;
  const { x, y, z, w } = first;
  return normalized({
    x: d * x + a * w + b * z - c * y,
    y: d * y - a * z + b * w + c * x,
    z: d * z + a * y - b * x + c * w,
    w: d * w - a * x - b * y - c * z,
  });
}

/** Returns a rotation about an axis, degrees. */
export function about(axis: 'x' | 'y' | 'z', degrees: number): Rotation {
  const half = (degrees * RADIANS) / 2;
  return { x: 0, y: 0, z: 0, [axis]: Math.sin(half), w: Math.cos(half) };
}

export function fromAngles({ yaw, pitch, roll }: Angles): Rotation {
  const { x, y, z, w } = turned(turned(about('x', roll), about('y', pitch)), about('z', yaw));
  return { x: rounded(x), y: rounded(y), z: rounded(z), w: rounded(w) };
}

export function toAngles(rotation: Rotation): Angles {
  const { x, y, z, w } = normalized(rotation);
  const sine = Math.max(-1, Math.min(1, 2 * (w * y - z * x)));
  return {
    yaw: Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)) / RADIANS,
    pitch: Math.asin(sine) / RADIANS,
    roll: Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)) / RADIANS,
  };
}

/** Rotates a point. */
export function rotate(
  rotation: Rotation,
  [px, py, pz]: readonly [number, number, number],
): readonly [number, number, number] {
  const { x, y, z, w } = rotation;
  const tx = 2 * (y * pz - z * py);
  const ty = 2 * (z * px - x * pz);
  const tz = 2 * (x * py - y * px);
  return [
    px + w * tx + y * tz - z * ty,
    py + w * ty + z * tx - x * tz,
    pz + w * tz + x * ty - y * tx,
  ];
}
