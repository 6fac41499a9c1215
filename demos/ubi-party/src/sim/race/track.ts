import { dot, length, type Vector } from '../plane/plane.ts';

/** A part of a track, in shares of a lap from 0 to 1. */
export interface Stretch {
  readonly from: number;
  readonly to: number;
}

/** Definition of a track. */
export interface TrackPlan {
  readonly id: string;
  readonly title: string;
  readonly laps: number;
  /** Units from the middle line to the kerb; a cart has radius 1. */
  readonly halfWidth: number;
  /** Corners of the closed middle line, units; the line leads through each. */
  readonly corners: readonly (readonly [x: number, y: number])[];
  /** Chevrons, that boost who drives over them. */
  readonly boosts: readonly Stretch[];
  /** The bridge, which makes carts jump that are fast enough. */
  readonly bridge?: Stretch;
}

/** A place on the middle line. */
export interface TrackPoint {
  readonly position: Vector;
  /** Forward, length 1. */
  readonly direction: Vector;
  /** Along the line from the start, units. */
  readonly distance: number;
}

export interface Track extends TrackPlan {
  /** Closed, evenly spread over the corners. */
  readonly points: readonly TrackPoint[];
  /** Of a lap, units. */
  readonly length: number;
}

const POINTS_PER_CORNER = 24;

/** A closed curve through the corners (Catmull and Rom 1974, uniform), measured. */
export function layTrack(plan: TrackPlan): Track {
  const { corners } = plan;
  const line = corners.flatMap((_, index) =>
    Array.from({ length: POINTS_PER_CORNER }, (_, part) =>
      curve(
        [-1, 0, 1, 2].map((step) => corners.at((index + step) % corners.length)!),
        part / POINTS_PER_CORNER,
      ),
    ),
  );
  const points: TrackPoint[] = [];
  let distance = 0;
  for (const [index, position] of line.entries()) {
    const next = line[(index + 1) % line.length]!;
    const step = { x: next.x - position.x, y: next.y - position.y };
    const size = length(step);
    points.push({ position, direction: { x: step.x / size, y: step.y / size }, distance });
    distance += size;
  }
  return { ...plan, points, length: distance };
}

function curve(corners: readonly (readonly [number, number])[], t: number): Vector {
  const [a, b, c, d] = corners as [Corner, Corner, Corner, Corner];
  const at = (axis: 0 | 1): number =>
    0.5 *
    (2 * b[axis] +
      t *
        (c[axis] -
          a[axis] +
          t *
            (2 * a[axis] -
              5 * b[axis] +
              4 * c[axis] -
              d[axis] +
              t * (3 * b[axis] - a[axis] - 3 * c[axis] + d[axis]))));
  return { x: at(0), y: at(1) };
}
type Corner = readonly [number, number];

/** The index of the last point that is not further along than a distance, which may be of any lap. */
export function indexAt(track: Track, distance: number): number {
  const within = inLap(track, distance);
  let [low, high] = [0, track.points.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (track.points[middle]!.distance <= within) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** The place on the middle line at a distance, of any lap. */
export function placeAt(track: Track, distance: number): TrackPoint {
  const { position, direction, distance: start } = track.points[indexAt(track, distance)]!;
  const on = inLap(track, distance) - start;
  return {
    position: { x: position.x + direction.x * on, y: position.y + direction.y * on },
    direction,
    distance,
  };
}

/** A position in track coordinates: distance along the middle line and offset to its left. */
export interface OnTrack {
  readonly distance: number;
  readonly toLeft: number;
}

/** Points before and after the last known one that are looked at: a cart moves less in a step, and tracks cross. */
const WINDOW = 10;

/**
 * Projects a position onto the track, near the previous projection. @param before distance of the step before, of any
 * lap
 */
export function findOnTrack(track: Track, position: Readonly<Vector>, before: number): OnTrack {
  const { points } = track;
  const middle = indexAt(track, before);
  let best = { squared: Infinity, along: 0, index: middle };
  for (let step = -WINDOW; step <= WINDOW; step += 1) {
    const index = (middle + step + points.length) % points.length;
    const point = points[index]!;
    const away = { x: position.x - point.position.x, y: position.y - point.position.y };
    const squared = dot(away, away);
    if (squared < best.squared) best = { squared, along: dot(away, point.direction), index };
  }
  const { position: on, direction, distance } = points[best.index]!;
  const away = { x: position.x - on.x, y: position.y - on.y };
  const moved = inLap(track, distance + best.along - before + track.length / 2) - track.length / 2;
  return { distance: before + moved, toLeft: direction.x * away.y - direction.y * away.x };
}

export function isOn({ from, to }: Stretch, track: Track, distance: number): boolean {
  const share = inLap(track, distance) / track.length;
  return share >= from && share <= to;
}

function inLap({ length }: Track, distance: number): number {
  return ((distance % length) + length) % length;
}

/** A round for the first time: wide, no crossing. */
const garden = layTrack({
  id: 'garden',
  title: 'Garden loop',
  laps: 3,
  halfWidth: 4.2,
  corners: [
    [-14, -15],
    [8, -16],
    [26, -12],
    [30, 2],
    [20, 12],
    [6, 8],
    [-8, 14],
    [-26, 12],
    [-30, -2],
  ],
  boosts: [
    { from: 0.1, to: 0.13 },
    { from: 0.62, to: 0.65 },
  ],
});

/** An eight, whose bridge leads over its own road; the grid is at the front left, where nothing hides it. */
const bridge = layTrack({
  id: 'bridge',
  title: 'Figure eight',
  laps: 3,
  halfWidth: 3.8,
  corners: [
    [-14, -13],
    [-2, -2.5],
    [12, 11.5],
    [26, 14],
    [32.5, 0],
    [26, -14],
    [12, -11.5],
    [-2, 2.5],
    [-14, 13],
    [-27, 14],
    [-33.5, 0],
    [-27, -14],
  ],
  boosts: [
    { from: 0.025, to: 0.053 },
    { from: 0.28, to: 0.308 },
  ],
  bridge: { from: 0.58, to: 0.64 },
});

/** Narrow, with bends in both directions. */
const workshop = layTrack({
  id: 'workshop',
  title: 'Workshop bends',
  laps: 3,
  halfWidth: 3.4,
  corners: [
    [-22, -17],
    [2, -19],
    [24, -18],
    [31, -9],
    [24, 4],
    [14, 6],
    [8, 10],
    [-1, 20],
    [-10, 19],
    [-19, 10],
    [-24, 5],
    [-31, -9],
  ],
  boosts: [
    { from: 0.06, to: 0.09 },
    { from: 0.72, to: 0.745 },
  ],
});

export const TRACKS: readonly Track[] = [garden, bridge, workshop];
