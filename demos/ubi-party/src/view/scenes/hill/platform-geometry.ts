import { ExtrudeGeometry, Shape, type BufferGeometry } from 'three';
import { toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';
import { buildTurned } from '../../toys/turned.ts';
import { BLOCK_HEIGHT, DRUM_RADIUS, PLATFORM_Y } from './platform-motion.ts';

const BEVEL = 0.07;
/** Between two blocks, units. */
const GAP = 0.05;

/** A block of a ring: its middle is the origin, outwards is +x, its top is level. */
export function buildRingBlock(inner: number, outer: number, blocks: number): BufferGeometry {
  const half = Math.PI / blocks;
  const middle = (inner + outer) / 2;
  const [from, to] = [inner + GAP / 2, outer - GAP / 2];
  // The gap is as wide at the outer edge as at the inner one
  const [inset, outset] = [half - GAP / 2 / from, half - GAP / 2 / to];
  const shape = new Shape();
  shape.moveTo(Math.cos(-outset) * to, Math.sin(-outset) * to);
  shape.absarc(0, 0, to, -outset, outset, false);
  shape.lineTo(Math.cos(inset) * from, Math.sin(inset) * from);
  shape.absarc(0, 0, from, inset, -inset, true);
  const flat = new ExtrudeGeometry(shape, {
    depth: BLOCK_HEIGHT - BEVEL * 2,
    bevelSize: BEVEL,
    bevelOffset: -BEVEL,
    bevelThickness: BEVEL,
    bevelSegments: 3,
    curveSegments: 10,
  });
  flat.translate(-middle, 0, -BLOCK_HEIGHT / 2 + BEVEL).rotateX(-Math.PI / 2);
  const block = toCreasedNormals(flat, 0.5);
  flat.dispose();
  block.deleteAttribute('uv');
  return block;
}

/** The disc that stays, of radius 1: it is drawn as wide as it is. */
export function buildDisc(radius: number): BufferGeometry {
  return buildTurned(
    [
      [0, -BLOCK_HEIGHT],
      [radius * 0.93, -BLOCK_HEIGHT],
      [radius, -BLOCK_HEIGHT * 0.6],
      [radius, 0],
      [0, 0],
    ],
    0.14,
    96,
  );
}

/** Base of the platform: a drum, and a neck that is as narrow at its top as the last of the disc. */
export function buildDrum(): BufferGeometry {
  const radius = DRUM_RADIUS;
  return buildTurned(
    [
      [0, 0],
      [radius, 0],
      [radius, 1.1],
      [radius - 0.5, 1.3],
      [0, 1.3],
    ],
    0.12,
    72,
  );
}
export function buildNeckOfHill(): BufferGeometry {
  const top = PLATFORM_Y - BLOCK_HEIGHT + 0.04;
  return buildTurned(
    [
      [0, 1.2],
      [5.6, 1.2],
      [5.3, 1.7],
      [1.1, top],
      [0, top],
    ],
    0.12,
    72,
  );
}
