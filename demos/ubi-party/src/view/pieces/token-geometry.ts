import { ExtrudeGeometry, type BufferGeometry, type Shape } from 'three';
import { mergeGeometries, toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';
import type { Shape as ShapeName } from '../../sim/index.ts';
import { outlineOf } from './outlines.ts';

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
