import { dot, unit, type Vector } from './vector.ts';

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
export interface Contact<D extends Disc> {
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
