import {
  ExtrudeGeometry,
  Mesh,
  Shape,
  SphereGeometry,
  type BufferGeometry,
  type Group,
} from 'three';
import { toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';
import type { Finish, Paints } from '../light/paints.ts';

/** Bare wood. */
export const WOOD = '#f6e6c8';

/** Puts toys into a group: each has its shadow, and its form is disposed with the group. */
export function placer(root: Group, paints: Paints) {
  return (
    geometry: BufferGeometry,
    colour: string,
    [x, y, z]: readonly [number, number, number],
    { turn = 0, finish = 'matte' as Finish } = {},
  ): Mesh => {
    const mesh = new Mesh(geometry, paints.of(colour, finish));
    mesh.position.set(x, y, z);
    mesh.rotation.y = turn;
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    root.add(mesh);
    return mesh;
  };
}

/** Disposes the forms of toys; their paints belong to the stage. */
export function disposeToys(root: Group): void {
  root.traverse((part) => {
    if (part instanceof Mesh) part.geometry.dispose();
  });
}

export function buildMarble(radius: number): BufferGeometry {
  return new SphereGeometry(radius, 40, 28).translate(0, radius, 0);
}

/** Stands on y = 0, open along z. */
export function buildArch(
  width: number,
  height: number,
  depth: number,
  thick: number,
): BufferGeometry {
  const [outer, inner] = [width / 2, width / 2 - thick];
  const shoulder = height - outer;
  const shape = new Shape();
  shape.moveTo(-outer, 0);
  shape.lineTo(-inner, 0);
  shape.lineTo(-inner, shoulder);
  shape.absarc(0, shoulder, inner, Math.PI, 0, true);
  shape.lineTo(inner, 0);
  shape.lineTo(outer, 0);
  shape.lineTo(outer, shoulder);
  shape.absarc(0, shoulder, outer, 0, Math.PI, false);
  return extrudeSoft(shape, depth);
}

/** Rises to the right, stands on y = 0. */
export function buildRamp(width: number, height: number, depth: number): BufferGeometry {
  const shape = new Shape();
  shape.moveTo(-width / 2, 0);
  shape.lineTo(width / 2, 0);
  shape.lineTo(width / 2, height);
  shape.lineTo(-width / 2, height * 0.06);
  return extrudeSoft(shape, depth);
}

/** Along z, its middle at 0, with a small soft bevel. */
export function extrudeSoft(shape: Shape, depth: number, bevel = 0.08): BufferGeometry {
  const flat = new ExtrudeGeometry(shape, {
    depth: depth - bevel * 2,
    bevelSize: bevel,
    bevelOffset: -bevel,
    bevelThickness: bevel,
    bevelSegments: 3,
    curveSegments: 28,
  });
  flat.translate(0, 0, bevel - depth / 2);
  const soft = toCreasedNormals(flat, 0.5);
  flat.dispose();
  soft.deleteAttribute('uv');
  return soft;
}
