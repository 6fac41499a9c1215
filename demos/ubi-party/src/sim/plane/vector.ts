/** A point or a direction on the table: x to the right, y away from who looks. One unit is the radius of a piece. */
export interface Vector {
  x: number;
  y: number;
}

export function length({ x, y }: Readonly<Vector>): number {
  return Math.sqrt(x * x + y * y);
}

/** The same direction with length 1; `otherwise` for a vector without length. */
export function unit(vector: Readonly<Vector>, otherwise: Readonly<Vector>): Vector {
  const size = length(vector);
  return size > 1e-9 ? { x: vector.x / size, y: vector.y / size } : { ...otherwise };
}

/** The vector, shortened to length 1 if it is longer: what a stick may say. */
export function withinOne(vector: Readonly<Vector>): Vector {
  return length(vector) > 1 ? unit(vector, vector) : { x: vector.x, y: vector.y };
}

/**
 * Turned counter-clockwise. The angle is given by the tangent of its half, for which half the angle in radians is close
 * enough in small steps: so the turn needs no sine and is exactly a rotation.
 */
export function turned({ x, y }: Readonly<Vector>, tangentOfHalf: number): Vector {
  const square = tangentOfHalf * tangentOfHalf;
  const cosine = (1 - square) / (1 + square);
  const sine = (2 * tangentOfHalf) / (1 + square);
  return { x: x * cosine - y * sine, y: x * sine + y * cosine };
}

/** Positive when `b` lies to the left of `a`. */
export function cross(a: Readonly<Vector>, b: Readonly<Vector>): number {
  return a.x * b.y - a.y * b.x;
}

export function dot(a: Readonly<Vector>, b: Readonly<Vector>): number {
  return a.x * b.x + a.y * b.y;
}

export function clamp(value: number, low: number, high: number): number {
  return Math.min(high, Math.max(low, value));
}
