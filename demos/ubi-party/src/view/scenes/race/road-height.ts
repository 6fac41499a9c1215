import type { Track } from '../../../sim/index.ts';
import { smooth } from '../../motion/ease.ts';

/** Of the bridge above the ground, units: a cart whose token ducks passes below it. */
export const BRIDGE_HEIGHT = 4.2;
/** Of the road, as a slab. */
export const ROAD_Y = 0.25;
/** Shares of a lap in which the road rises to the bridge, and falls after it. */
const RISE = 0.085;

/** Height of the road at a distance along it, of any lap. */
export function roadHeight(track: Track, distance: number): number {
  if (!track.bridge) return ROAD_Y;
  const share = (((distance / track.length) % 1) + 1) % 1;
  const up = smooth((share - (track.bridge.from - RISE)) / (RISE - 0.012));
  const down = smooth((track.bridge.to + RISE - share) / (RISE - 0.012));
  return ROAD_Y + BRIDGE_HEIGHT * Math.min(up, down);
}

/** Units along the road at which it is nearest to the bridge, but below it. */
export function underpassOf(track: Track): number | undefined {
  if (!track.bridge) return undefined;
  const deck = track.points.filter(
    ({ distance }) => roadHeight(track, distance) > BRIDGE_HEIGHT * 0.9,
  );
  let best = { squared: Infinity, distance: 0 };
  for (const { position, distance } of track.points) {
    if (roadHeight(track, distance) > 1) continue;
    for (const above of deck) {
      const [dx, dy] = [position.x - above.position.x, position.y - above.position.y];
      const squared = dx * dx + dy * dy;
      if (squared < best.squared) best = { squared, distance };
    }
  }
  return best.distance;
}

/** Amount by which a token ducks under a bridge, 0 to 1. @param underpass units along the road */
export function duckOf(track: Track, underpass: number | undefined, distance: number): number {
  if (underpass === undefined) return 0;
  const half = track.length / 2;
  const away = Math.abs(
    ((((distance - underpass + half) % track.length) + track.length) % track.length) - half,
  );
  return smooth((track.halfWidth + 5.5 - away) / 3);
}
