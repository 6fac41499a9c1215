import { BufferGeometry, Color, Float32BufferAttribute } from 'three';

import { placeAt, type Track } from '../../../sim/index.ts';
import { smooth } from '../../motion/motion.ts';

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

const ASPHALT = '#4a4650';
const SIDE = '#3c3842';
const KERBS = ['#fff6e4', '#e8674f'] as const;
const DASH = '#a8a29f';
const CHEVRON = '#f2c230';
const CHECKERS = ['#221c14', '#fff6e4'] as const;

/** Units. */
const KERB = { width: 0.85, height: 0.32, length: 2.4 } as const;
const DASH_SIZE = { length: 1.7, every: 4.4, width: 0.24 } as const;
/** Above the road, so that paint does not fight with it. */
const PAINT_Y = 0.035;
const PARTS_PER_KERB = 4;
const CHECKER = 0.85;

type Corner = readonly [x: number, y: number, z: number];

/** Collects coloured quads: the whole road is one drawing. */
class Quads {
  readonly #positions: number[] = [];
  readonly #colours: number[] = [];
  readonly #colour = new Color();

  /** Corners counter-clockwise, seen from the side that is drawn. */
  add(colour: string, a: Corner, b: Corner, c: Corner, d: Corner): void {
    this.#colour.set(colour);
    const { r, g, b: blue } = this.#colour;
    for (const corner of [a, b, c, a, c, d]) {
      this.#positions.push(...corner);
      this.#colours.push(r, g, blue);
    }
  }

  build(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(this.#positions, 3));
    geometry.setAttribute('color', new Float32BufferAttribute(this.#colours, 3));
    geometry.computeVertexNormals();
    return geometry;
  }
}

/** A point beside the middle line. @param toLeft units @param up above the road */
export function beside(track: Track, distance: number, toLeft: number, up = 0): Corner {
  const { position } = placeAt(track, distance);
  const { x, y } = smoothDirection(track, distance);
  return [position.x - y * toLeft, roadHeight(track, distance) + up, -(position.y + x * toLeft)];
}

/** The middle line has corners at its points: across them, the edge would be jagged. */
function smoothDirection(track: Track, distance: number): { x: number; y: number } {
  const [a, b] = [placeAt(track, distance - 0.6).position, placeAt(track, distance + 0.6).position];
  const [x, y] = [b.x - a.x, b.y - a.y];
  const size = Math.hypot(x, y);
  return { x: x / size, y: y / size };
}

/** The road as a slab, with kerbs, dashes, start line and chevrons, coloured by vertex. */
export function buildRoad(track: Track): BufferGeometry {
  const quads = new Quads();
  addSlab(quads, track);
  addDashes(quads, track);
  addCheckers(quads, track);
  for (const { from, to } of track.boosts) {
    addChevrons(quads, track, from * track.length, to * track.length);
  }
  return quads.build();
}

function addSlab(quads: Quads, track: Track): void {
  // An even number of kerbs, so that no two of a colour meet at the start
  const kerbs = 2 * Math.round(track.length / KERB.length / 2);
  const parts = kerbs * PARTS_PER_KERB;
  const at = (part: number): number => (part / parts) * track.length;
  for (let part = 0; part < parts; part += 1) {
    const [from, to] = [at(part), at(part + 1)];
    const kerb = KERBS[Math.floor(part / PARTS_PER_KERB) % 2]!;
    const half = track.halfWidth;
    const strip = (colour: string, outer: [number, number], inner: [number, number]): void =>
      quads.add(
        colour,
        beside(track, from, ...outer),
        beside(track, from, ...inner),
        beside(track, to, ...inner),
        beside(track, to, ...outer),
      );
    strip(ASPHALT, [half, 0], [-half, 0]);
    const wide = half + KERB.width;
    for (const side of [1, -1] as const) {
      const edges: [string, [number, number], [number, number]][] = [
        [kerb, [wide, KERB.height], [half, KERB.height]],
        [kerb, [half, KERB.height], [half, 0]],
        [kerb, [wide + 0.06, -0.3], [wide, KERB.height]],
        [SIDE, [wide, -0.75], [wide, -0.3]],
      ];
      for (const [colour, outer, inner] of edges) {
        if (side === 1) strip(colour, outer, inner);
        else strip(colour, [-inner[0], inner[1]], [-outer[0], outer[1]]);
      }
    }
    // Seen from below: the bridge
    strip(SIDE, [-wide, -0.75], [wide, -0.75]);
  }
}

function addDashes(quads: Quads, track: Track): void {
  const count = Math.round(track.length / DASH_SIZE.every);
  for (let index = 0; index < count; index += 1) {
    const from = ((index + 0.5) / count) * track.length;
    const to = from + DASH_SIZE.length;
    const half = DASH_SIZE.width / 2;
    quads.add(
      DASH,
      beside(track, from, half, PAINT_Y),
      beside(track, from, -half, PAINT_Y),
      beside(track, to, -half, PAINT_Y),
      beside(track, to, half, PAINT_Y),
    );
  }
}

function addCheckers(quads: Quads, track: Track): void {
  const columns = 2 * Math.round(track.halfWidth / CHECKER);
  const width = (track.halfWidth * 2) / columns;
  for (let row = 0; row < 3; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      const [left, from] = [track.halfWidth - column * width, (row - 1.5) * width];
      quads.add(
        CHECKERS[(row + column) % 2]!,
        beside(track, from, left, PAINT_Y * 1.5),
        beside(track, from, left - width, PAINT_Y * 1.5),
        beside(track, from + width, left - width, PAINT_Y * 1.5),
        beside(track, from + width, left, PAINT_Y * 1.5),
      );
    }
  }
}

function addChevrons(quads: Quads, track: Track, from: number, to: number): void {
  const half = track.halfWidth * 0.62;
  const [thick, point] = [1.15, half * 0.8];
  const count = Math.max(2, Math.round((to - from) / (thick * 1.75)));
  for (let index = 0; index < count; index += 1) {
    const tail = from + ((index + 0.2) / count) * (to - from);
    for (const side of [1, -1] as const) {
      const corners = [
        beside(track, tail, half * side, PAINT_Y * 1.5),
        beside(track, tail + point, 0, PAINT_Y * 1.5),
        beside(track, tail + point + thick, 0, PAINT_Y * 1.5),
        beside(track, tail + thick, half * side, PAINT_Y * 1.5),
      ] as const;
      const [a, b, c, d] = corners;
      if (side === 1) quads.add(CHEVRON, a, b, c, d);
      else quads.add(CHEVRON, d, c, b, a);
    }
  }
}
