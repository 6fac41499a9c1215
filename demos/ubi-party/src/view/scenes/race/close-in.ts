import { lapOf, type RaceState, type Track } from '../../../sim/index.ts';
import { mix, smooth } from '../../motion/ease.ts';

/** The camera closes in by so much on the last lap. */
const LAST_LAP = 1.15;
/** Shares of half of the circuit's width: carts that are further apart than the second need the whole picture. */
const NEAR = 0.45;
const FAR = 0.85;

/** Zoom of the camera, and the point of the table that keeps its place in the picture. */
export interface CloseIn {
  readonly zoom: number;
  readonly x: number;
  readonly z: number;
}

/** On the last lap of the first, around those who still drive, as far as all of them stay in the picture. */
export function closeIn({ carts }: RaceState, track: Track, halfWidth: number): CloseIn {
  const driving = carts.filter(({ finishedAt }) => finishedAt === undefined);
  const seen = driving.length > 0 ? driving : carts;
  const xs = seen.map(({ position }) => position.x);
  const ys = seen.map(({ position }) => position.y);
  const middle = (values: readonly number[]): number =>
    values.length === 0 ? 0 : (Math.min(...values) + Math.max(...values)) / 2;
  const [x, y] = [middle(xs), middle(ys)];
  const isLast = carts.some((cart) => lapOf(cart, track) === track.laps);
  const spread = Math.max(0, ...xs.map((at) => Math.abs(at - x))) / halfWidth;
  const zoom = isLast ? mix(LAST_LAP, 1, smooth((spread - NEAR) / (FAR - NEAR))) : 1;
  return { zoom, x, z: -y };
}
