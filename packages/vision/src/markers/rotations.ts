export interface Vector3Value {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

export interface QuaternionValue extends Vector3Value {
  readonly w: number;
}

/** The quaternion (w not negative) of a turn about an axis, by an angle that is the length of the axis, radians. */
export function quaternionOfAxisAngle([x, y, z]: readonly [
  number,
  number,
  number,
]): QuaternionValue {
  const angle = Math.hypot(x, y, z);
  const factor = angle < 1e-9 ? 0.5 : Math.sin(angle / 2) / angle;
  const w = Math.cos(angle / 2);
  const sign = w < 0 ? -1 : 1;
  return { x: sign * x * factor, y: sign * y * factor, z: sign * z * factor, w: sign * w };
}

/** The axis, as long as the angle in radians, of a unit quaternion. */
export function axisAngleOfQuaternion({
  x,
  y,
  z,
  w,
}: QuaternionValue): readonly [number, number, number] {
  const sine = Math.hypot(x, y, z);
  if (sine < 1e-12) return [0, 0, 0];
  const factor = (2 * Math.atan2(sine, w)) / sine;
  return [x * factor, y * factor, z * factor];
}

/** First b, then a. */
export function multiply(a: QuaternionValue, b: QuaternionValue): QuaternionValue {
  return {
    x: a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
    y: a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
    z: a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
    w: a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
  };
}

/** Turns a vector by a unit quaternion. */
export function rotate(q: QuaternionValue, { x, y, z }: Vector3Value): Vector3Value {
  const turned = multiply(multiply(q, { x, y, z, w: 0 }), { x: -q.x, y: -q.y, z: -q.z, w: q.w });
  return { x: turned.x, y: turned.y, z: turned.z };
}

/** Smallest angle between two orientations, radians. */
export function angleBetween(a: QuaternionValue, b: QuaternionValue): number {
  return 2 * Math.acos(Math.min(1, Math.abs(a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w)));
}

/** Between two orientations, the shorter way round; normalised linear, for small differences. */
export function blend(a: QuaternionValue, b: QuaternionValue, part: number): QuaternionValue {
  const sign = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0 ? -1 : 1;
  const mix = (from: number, to: number): number => from + (sign * to - from) * part;
  const mixed = { x: mix(a.x, b.x), y: mix(a.y, b.y), z: mix(a.z, b.z), w: mix(a.w, b.w) };
  const length = Math.hypot(mixed.x, mixed.y, mixed.z, mixed.w) || 1;
  return { x: mixed.x / length, y: mixed.y / length, z: mixed.z / length, w: mixed.w / length };
}
