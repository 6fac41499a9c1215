import type { Track } from '../../../sim/index.ts';
import { scatter } from '../../motion/motion.ts';
import { roadHeight } from './road.ts';

/** A place beside the road, in the plane of the rules, units. */
export interface Spot {
  readonly x: number;
  readonly y: number;
}

/** Bounds of a track with its kerbs. */
export function boundsOf(track: Track): { minX: number; maxX: number; minY: number; maxY: number } {
  const reach = track.halfWidth + 1;
  const xs = track.points.map(({ position }) => position.x);
  const ys = track.points.map(({ position }) => position.y);
  return {
    minX: Math.min(...xs) - reach,
    maxX: Math.max(...xs) + reach,
    minY: Math.min(...ys) - reach,
    maxY: Math.max(...ys) + reach,
  };
}

/** Units from a spot to the edge of the road; negative on it. */
export function offRoad(track: Track, { x, y }: Spot): number {
  let squared = Infinity;
  for (const { position } of track.points) {
    const [dx, dy] = [position.x - x, position.y - y];
    squared = Math.min(squared, dx * dx + dy * dy);
  }
  return Math.sqrt(squared) - track.halfWidth - 0.9;
}

/** Length of ground that a toy hides behind it, per unit of its height (camera 36 degrees down). */
const HIDES = 1.2;

/** Whether a toy of this radius and height stands free, and hides no road behind it. */
export function isFree(track: Track, spot: Spot, radius: number, height: number): boolean {
  for (let away = 0; away <= height * HIDES; away += 1.5) {
    if (offRoad(track, { x: spot.x, y: spot.y + away }) < radius) return false;
  }
  return true;
}

/** Spots for toys, the same in each run. @param taken spots of other toys, with their radius */
export function freeSpots(
  track: Track,
  wanted: {
    readonly count: number;
    readonly radius: number;
    readonly height: number;
    readonly salt: number;
  },
  taken: (Spot & { readonly radius: number })[],
): Spot[] {
  const { minX, maxX, minY, maxY } = boundsOf(track);
  const spots: Spot[] = [];
  for (let index = 0; index < 900 && spots.length < wanted.count; index += 1) {
    const spot = {
      x: minX + 1 + scatter(index, wanted.salt) * (maxX - minX - 2),
      y: minY + scatter(index, wanted.salt + 1) * (maxY - minY + 7),
    };
    const isTaken = taken.some(
      ({ x, y, radius }) => Math.hypot(x - spot.x, y - spot.y) < radius + wanted.radius + 0.4,
    );
    if (isTaken || !isFree(track, spot, wanted.radius, wanted.height)) continue;
    spots.push(spot);
    taken.push({ ...spot, radius: wanted.radius });
  }
  return spots;
}

/** Positions of the bridge's pillars: at both edges, but not on the road below. */
export function pillarsOf(track: Track): (Spot & { readonly height: number })[] {
  const pillars: (Spot & { height: number })[] = [];
  const low = track.points.filter(({ distance }) => roadHeight(track, distance) < 1);
  let last = -Infinity;
  for (const { position, direction, distance } of track.points) {
    const height = roadHeight(track, distance);
    if (height < 1.4 || distance - last < 4.5) continue;
    last = distance;
    for (const side of [-1, 1]) {
      const away = side * (track.halfWidth - 0.1);
      const spot = { x: position.x - direction.y * away, y: position.y + direction.x * away };
      const isOnRoad = low.some(
        (point) =>
          Math.hypot(point.position.x - spot.x, point.position.y - spot.y) < track.halfWidth + 1.2,
      );
      if (!isOnRoad) pillars.push({ ...spot, height: height - 0.6 });
    }
  }
  return pillars;
}
