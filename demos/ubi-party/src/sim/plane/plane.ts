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

/** A round piece on the table. */
export interface Disc {
  readonly position: Vector;
  /** Units per second. */
  readonly velocity: Vector;
  readonly radius: number;
  readonly mass: number;
  /** Coefficient of restitution: 0 no bounce, 1 elastic, more for springs. */
  readonly bounce: number;
}

/** Two discs that met in this step. */
interface Contact<D extends Disc> {
  readonly a: D;
  readonly b: D;
  /** Units per second at which they met. */
  readonly speed: number;
}

/**
 * Moves discs that overlap apart and lets them bounce, in the order of the list. Each pair is looked at: there are at
 * most 32 discs.
 */
export function collide<D extends Disc>(discs: readonly D[]): Contact<D>[] {
  const contacts: Contact<D>[] = [];
  for (const [index, a] of discs.entries()) {
    for (const b of discs.slice(index + 1)) {
      const contact = collidePair(a, b);
      if (contact) contacts.push(contact);
    }
  }
  return contacts;
}

function collidePair<D extends Disc>(a: D, b: D): Contact<D> | undefined {
  const between = { x: b.position.x - a.position.x, y: b.position.y - a.position.y };
  const reach = a.radius + b.radius;
  const squared = dot(between, between);
  if (squared >= reach * reach) return undefined;
  const normal = unit(between, { x: 1, y: 0 });
  const shareOfA = b.mass / (a.mass + b.mass);
  const overlap = reach - Math.sqrt(squared);
  move(a.position, normal, -overlap * shareOfA);
  move(b.position, normal, overlap * (1 - shareOfA));

  const speed = dot(a.velocity, normal) - dot(b.velocity, normal);
  if (speed <= 0) return { a, b, speed: 0 };
  const impulse = (1 + Math.max(a.bounce, b.bounce)) * speed;
  move(a.velocity, normal, -impulse * shareOfA);
  move(b.velocity, normal, impulse * (1 - shareOfA));
  return { a, b, speed };
}

function move(vector: Vector, direction: Readonly<Vector>, by: number): void {
  vector.x += direction.x * by;
  vector.y += direction.y * by;
}
