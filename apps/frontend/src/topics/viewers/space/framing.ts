import { ORIGIN, type Point, type SpaceThing } from './space-things.ts';

/** Visible part of the scene. */
export interface Sphere {
  readonly center: Point;
  readonly radius: number;
}

/** Factor on the radius of a group, for axes and names. */
const MARGIN = 1.2;

/**
 * Visible part of the first picture: the whole ground, or for several objects the sphere around them and the origin, so
 * that markers in front of a camera are not a small cluster in the centre. Once an object leaves that sphere, the
 * ground is used from then on.
 */
export class Framing {
  #sphere: Sphere | undefined;
  #isWhole = false;

  /** @param reach half the size of the ground */
  around(things: readonly SpaceThing[], reach: number): Sphere {
    const whole: Sphere = { center: ORIGIN, radius: reach };
    if (this.#sphere === undefined && things.length > 1) this.#sphere = sphereOf(things);
    const sphere = this.#sphere;
    if (sphere === undefined || this.#isWhole) return whole;
    const isOutside = things.some(({ at }) => apart(at, sphere.center) > sphere.radius);
    this.#isWhole = isOutside || sphere.radius > reach;
    return this.#isWhole ? whole : sphere;
  }

  /** Restarts the framing for the next objects. */
  clear(): void {
    this.#sphere = undefined;
    this.#isWhole = false;
  }
}

/** Returns a sphere around the objects and the origin. */
function sphereOf(things: readonly SpaceThing[]): Sphere {
  const points = [ORIGIN, ...things.map(({ at }) => at)];
  const along = (axis: 0 | 1 | 2) => points.map((point) => point[axis]);
  const least = ([0, 1, 2] as const).map((axis) => Math.min(...along(axis)));
  const most = ([0, 1, 2] as const).map((axis) => Math.max(...along(axis)));
  const center = least.map((part, axis) => (part + most[axis]!) / 2) as unknown as Point;
  const half = Math.max(...points.map((point) => apart(point, center)));
  const extents = things.map(({ size }) => (size ? Math.hypot(...size) / 2 : 0));
  return { center, radius: MARGIN * (half + Math.max(...extents)) };
}

function apart(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
