import { Path, Shape, Vector2, ExtrudeGeometry, type BufferGeometry } from 'three';
import { mergeGeometries, toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';

import type { Shape as ShapeName } from '../../sim/index.ts';

/** The front of a piece: units, the piece stands with its lowest point on 0. */
interface Outline {
  readonly shape: Shape;
  /** Position of the letter, and width and height of its field. */
  readonly letter: { readonly x: number; readonly y: number; readonly size: number };
  /** A part that lies deeper than the rest and carries the letter. */
  readonly inset?: Shape;
}

type Corner = readonly [x: number, y: number];

/** About the same for all shapes, so that no player is larger: the height of a circle of radius 1.05. */
const OUTLINES: Readonly<Record<ShapeName, () => Outline>> = {
  circle: () => ({ shape: disc(1.05, 1.05), letter: { x: 0, y: 1.05, size: 1.45 } }),
  triangle: () => ({
    shape: polygon(
      [
        [-1.3, 0],
        [1.3, 0],
        [0, 2.2],
      ],
      0.1,
    ),
    letter: { x: 0, y: 0.7, size: 1.25 },
  }),
  square: () => ({
    shape: polygon(
      [
        [-0.95, 0],
        [0.95, 0],
        [0.95, 1.9],
        [-0.95, 1.9],
      ],
      0.12,
    ),
    letter: { x: 0, y: 0.95, size: 1.45 },
  }),
  star: () => ({ shape: polygon(star(), 0.09), letter: { x: 0, y: 1.04, size: 1.22 } }),
  diamond: () => ({
    shape: polygon(
      [
        [0, 0],
        [1.05, 1.2],
        [0, 2.4],
        [-1.05, 1.2],
      ],
      0.1,
    ),
    letter: { x: 0, y: 1.2, size: 1.28 },
  }),
  cross: () => ({ shape: polygon(cross(), 0.1), letter: { x: 0, y: 1.1, size: 1.22 } }),
  hexagon: () => ({ shape: polygon(regular(6, 1.15, 1), 0.1), letter: { x: 0, y: 1, size: 1.4 } }),
  drop: () => ({ shape: drop(), letter: { x: 0, y: 0.95, size: 1.25 } }),
  ring: () => {
    const shape = disc(1.08, 1.08);
    const hole = new Path();
    hole.absarc(0, 1.08, 0.74, 0, Math.PI * 2, true);
    shape.holes.push(hole);
    return { shape, inset: disc(0.8, 1.08), letter: { x: 0, y: 1.08, size: 1.2 } };
  },
  moon: () => ({ shape: moon(), letter: { x: -0.4, y: 0.86, size: 1.12 } }),
  flower: () => ({ shape: flower(), letter: { x: 0, y: 1.1, size: 1.3 } }),
  heart: () => ({ shape: heart(), letter: { x: 0, y: 1.18, size: 1.25 } }),
};

export function outlineOf(shape: ShapeName): Outline {
  return OUTLINES[shape]();
}

function disc(radius: number, y: number): Shape {
  const shape = new Shape();
  shape.absarc(0, y, radius, 0, Math.PI * 2, false);
  return shape;
}

/** With round corners. */
function polygon(corners: readonly Corner[], radius: number): Shape {
  const shape = new Shape();
  for (const [index, corner] of corners.entries()) {
    const at = new Vector2(...corner);
    const before = new Vector2(...corners.at(index - 1)!);
    const after = new Vector2(...corners[(index + 1) % corners.length]!);
    const from = before.sub(at).setLength(radius).add(at);
    const to = after.sub(at).setLength(radius).add(at);
    if (index === 0) shape.moveTo(from.x, from.y);
    else shape.lineTo(from.x, from.y);
    shape.quadraticCurveTo(at.x, at.y, to.x, to.y);
  }
  shape.closePath();
  return shape;
}

function regular(count: number, radius: number, y: number): Corner[] {
  return Array.from({ length: count }, (_, index) => {
    const angle = (index / count) * Math.PI * 2;
    return [Math.cos(angle) * radius, y + Math.sin(angle) * radius] as const;
  });
}

function star(): Corner[] {
  const [outer, inner] = [1.3, 0.68];
  const foot = -Math.cos(Math.PI * 0.8) * outer;
  return Array.from({ length: 10 }, (_, index) => {
    const angle = Math.PI / 2 + (index / 10) * Math.PI * 2;
    const radius = index % 2 === 0 ? outer : inner;
    return [Math.cos(angle) * radius, foot + Math.sin(angle) * radius] as const;
  });
}

function cross(): Corner[] {
  const [a, b] = [0.46, 1.1];
  const quarter: readonly Corner[] = [
    [a, b],
    [a, a],
    [b, a],
  ];
  const corners = [0, 1, 2, 3].flatMap((turn) =>
    quarter.map(([x, y]): Corner => {
      let corner: Corner = [x, y];
      for (let index = 0; index < turn; index += 1) corner = [corner[1], -corner[0]];
      return corner;
    }),
  );
  return corners.map(([x, y]) => [x, y + b] as const).reverse();
}

function drop(): Shape {
  const shape = new Shape();
  shape.moveTo(0, 2.5);
  shape.bezierCurveTo(0.22, 2.1, 1.02, 1.55, 1.02, 0.98);
  shape.absarc(0, 0.98, 1.02, 0, -Math.PI, true);
  shape.bezierCurveTo(-1.02, 1.55, -0.22, 2.1, 0, 2.5);
  return shape;
}

/** A circle from which a smaller one is cut, with blunt tips. */
function moon(): Shape {
  const [radius, cut] = [1.15, 0.78];
  const [cutX, cutY] = [0.62, 0.52];
  const away = Math.hypot(cutX, cutY);
  const along = (away * away + radius * radius - cut * cut) / (2 * away);
  const side = Math.acos(along / radius);
  const middle = Math.atan2(cutY, cutX);
  const [from, to] = [middle + side + 0.05, middle - side - 0.05 + Math.PI * 2];
  const outer = Array.from({ length: 49 }, (_, index) => {
    const angle = from + ((to - from) * index) / 48;
    return new Vector2(Math.cos(angle) * radius, Math.sin(angle) * radius);
  });
  const angleOf = ({ x, y }: Vector2): number => Math.atan2(y - cutY, x - cutX);
  const start = angleOf(outer.at(-1)!);
  const end = angleOf(outer[0]!);
  // Back along the cut, through its side that is nearest to the middle of the moon
  const swept = end > start ? end - Math.PI * 2 : end;
  const inner = Array.from({ length: 25 }, (_, index) => {
    const angle = start + ((swept - start) * (index + 0.5)) / 25;
    return new Vector2(cutX + Math.cos(angle) * cut, cutY + Math.sin(angle) * cut);
  });
  return new Shape([...outer, ...inner].map(({ x, y }) => new Vector2(x, y + radius)));
}

function flower(): Shape {
  const points = Array.from({ length: 96 }, (_, index) => {
    const angle = (index / 96) * Math.PI * 2;
    const radius = 0.98 + 0.15 * Math.cos(angle * 6);
    return new Vector2(Math.sin(angle) * radius, 1.13 + Math.cos(angle) * radius);
  });
  return new Shape(points.reverse());
}

function heart(): Shape {
  const shape = new Shape();
  shape.moveTo(0, 0);
  shape.bezierCurveTo(0.35, 0.42, 1.2, 0.95, 1.2, 1.52);
  shape.bezierCurveTo(1.2, 2.28, 0.25, 2.38, 0, 1.78);
  shape.bezierCurveTo(-0.25, 2.38, -1.2, 2.28, -1.2, 1.52);
  shape.bezierCurveTo(-1.2, 0.95, -0.35, 0.42, 0, 0);
  return shape;
}

/** From front to back, units. */
export const TOKEN_DEPTH = 0.56;
const BEVEL = 0.07;
/** Depth of a ring's inset behind its front. */
const INSET = 0.16;
/** Edges that are sharper than this stay edges, radians. */
const CREASE = 0.6;

/** A wooden piece: extruded, with a small soft bevel; stands on y = 0, its front looks along +z. */
export function buildToken(shape: ShapeName): BufferGeometry {
  const outline = outlineOf(shape);
  const body = extrude(outline.shape, TOKEN_DEPTH, BEVEL);
  if (!outline.inset) return body;
  const inset = extrude(outline.inset, TOKEN_DEPTH - INSET * 2, 0.02);
  const both = mergeGeometries([body, inset]);
  body.dispose();
  inset.dispose();
  return both;
}

/** Distance of the letter in front of the middle of a piece. */
export function letterDepth(shape: ShapeName): number {
  return TOKEN_DEPTH / 2 - (shape === 'ring' ? INSET : 0) + 0.015;
}

/** A thin piece of the same shape, for confetti: lies round the origin, about one unit across. */
export function buildConfetti(shape: ShapeName): BufferGeometry {
  const geometry = new ExtrudeGeometry(outlineOf(shape).shape, {
    depth: 0.2,
    bevelEnabled: false,
    curveSegments: 5,
  });
  geometry.center().scale(0.42, 0.42, 0.42);
  return geometry;
}

function extrude(shape: Shape, depth: number, bevel: number): BufferGeometry {
  const geometry = new ExtrudeGeometry(shape, {
    depth: depth - bevel * 2,
    bevelSize: bevel,
    bevelOffset: -bevel,
    bevelThickness: bevel,
    bevelSegments: 3,
    curveSegments: 22,
  });
  geometry.translate(0, 0, bevel - depth / 2);
  const creased = toCreasedNormals(geometry, CREASE);
  geometry.dispose();
  creased.deleteAttribute('uv');
  return creased;
}
