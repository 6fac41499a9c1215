import { Group, Mesh, SphereGeometry, type BufferGeometry } from 'three';
import type { Paints } from '../../light/paints.ts';
import { buildBlock, buildCone, buildCylinder } from '../../toys/turned.ts';

const COLOUR = '#4e5c93';

/** Toys round the hill in the colour of the evening: there, but never in the way of the eye. */
export function buildHillProps(paints: Paints): Group {
  const root = new Group();
  const add = (geometry: BufferGeometry, x: number, y: number, z: number, turn = 0): void => {
    const mesh = new Mesh(geometry, paints.of(COLOUR, 'matte'));
    mesh.position.set(x, y, z);
    mesh.rotation.y = turn;
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    root.add(mesh);
  };
  add(buildBlock(2.6, 2.6, 2.6, 0.14), -16.6, 0, -8.5, 0.35);
  add(buildBlock(2, 2, 2, 0.12), -16.7, 2.6, -8.5, -0.3);
  add(buildCylinder(1.6, 2.4, 0.16), 17, 0, -9.5);
  add(new SphereGeometry(1.35, 40, 28), 17, 3.6, -9.5);
  add(buildCone(1.7, 3.2, 0.16), 21.5, 0, -1.5);
  add(buildCone(1.2, 2.2, 0.14), -22, 0, 2);
  return root;
}
