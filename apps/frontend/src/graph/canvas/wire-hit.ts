import type { Point } from '../model/graph.ts';
import { cornersOf, curvesOf, goesBack, onCurve } from './wire-path.ts';

/** Point on a wire. */
export interface WireSpot extends Point {
  /** Number of the wire's bend points before this point. */
  readonly leg: number;
}

/** Point on a wire, and its distance from another point. */
export interface NearSpot extends WireSpot {
  readonly distance: number;
}

/** Number of samples per curve; between them wires are taken as straight. */
const STEPS = 16;

/** Samples of a wire from its start to its end. */
export function spotsOf(from: Point, to: Point, points: readonly Point[]): readonly WireSpot[] {
  if (goesBack(from, to, points))
    return cornersOf(from, to).map((corner) => ({ ...corner, leg: 0 }));
  const curves = curvesOf(from, to, points);
  return curves.flatMap((curve, leg) =>
    Array.from({ length: STEPS + 1 }, (_, step) => ({ ...onCurve(curve, step / STEPS), leg })),
  );
}

/** Returns the point of a wire that is nearest to another point. */
export function nearestOn(spots: readonly WireSpot[], place: Point): NearSpot | undefined {
  let best: NearSpot | undefined;
  for (let index = 1; index < spots.length; index += 1) {
    const spot = nearestBetween(spots[index - 1]!, spots[index]!, place);
    if (best === undefined || spot.distance < best.distance) best = spot;
  }
  return best;
}

function nearestBetween(a: WireSpot, b: WireSpot, place: Point): NearSpot {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const whole = dx * dx + dy * dy;
  const along = whole === 0 ? 0 : ((place.x - a.x) * dx + (place.y - a.y) * dy) / whole;
  const part = Math.min(1, Math.max(0, along));
  const [x, y] = [a.x + dx * part, a.y + dy * part];
  // Where two legs meet, the point belongs to the later one.
  return { x, y, leg: b.leg, distance: Math.hypot(place.x - x, place.y - y) };
}

/** Centre of the longest leg: position of a bend point added without a pointer. */
export function roomiest(from: Point, to: Point, points: readonly Point[]): WireSpot {
  const stops = [from, ...points, to];
  let leg = 0;
  let longest = -1;
  for (let index = 1; index < stops.length; index += 1) {
    const [a, b] = [stops[index - 1]!, stops[index]!];
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    if (length > longest) [longest, leg] = [length, index - 1];
  }
  const spots = spotsOf(from, to, points).filter((spot) => spot.leg === leg);
  const middle = Math.floor(spots.length / 2);
  const [a, b] =
    spots.length % 2 === 1
      ? [spots[middle]!, spots[middle]!]
      : [spots[middle - 1]!, spots[middle]!];
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, leg };
}
