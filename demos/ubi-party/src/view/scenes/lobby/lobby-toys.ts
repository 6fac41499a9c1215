import { Group } from 'three';
import type { ContactShades } from '../../light/ground-shade.ts';
import type { Paints } from '../../light/paints.ts';
import { buildArch, buildMarble, buildRamp, placer, WOOD } from '../../toys/toy-box.ts';
import { buildBlock, buildCone, buildCylinder } from '../../toys/turned.ts';

/** The toys behind the players, on a strip of 16 units; the back row stands at z = 0. */
export function buildLobbyToys(paints: Paints): Group {
  const root = new Group();
  const add = placer(root, paints);
  add(buildCylinder(0.95, 3.9, 0.1), '#3f6fc0', [-5.7, 0, -3.4]);
  add(buildMarble(1), '#f2a71e', [-5.7, 3.86, -3.4], { finish: 'marble' });
  add(buildArch(5, 4.9, 1.6, 1.35), WOOD, [0.1, 0, -5.6], { turn: 0.06 });
  add(buildRamp(4.2, 2.2, 1.6), '#f191b8', [4.3, 0, -5.6], { turn: 0.12 });
  add(buildBlock(2.3, 2.5, 2.3, 0.12), '#e8843c', [6.9, 0, -4.4], { turn: 0.14 });
  add(buildBlock(2.3, 2.3, 2.3, 0.12), WOOD, [9.4, 0, -5.4], { turn: 0.1 });
  add(buildCone(1.35, 2.6, 0.12), '#3aa66f', [9.4, 2.3, -5.4]);
  add(buildBlock(2, 2, 2, 0.12), '#e9dcc2', [12, 0, -6.6], { turn: -0.2 });
  return root;
}

const SHADES: readonly (readonly [x: number, z: number, width: number, depth: number])[] = [
  [-5.7, -3.4, 3.4, 2.8],
  [-1.6, -5.6, 3, 3],
  [2, -5.6, 3, 3],
  [4.3, -5.6, 6, 3],
  [6.9, -4.4, 4, 3.6],
  [9.4, -5.4, 4, 3.6],
];

export function shadeToys(toys: Group, shades: ContactShades): void {
  const { position, scale } = toys;
  for (const [x, z, width, depth] of SHADES) {
    const size = scale.x;
    shades.add(position.x + x * size, 0, position.z + z * size, width * size, depth * size);
  }
}

const MARBLES = [
  { colour: '#e8452f', radius: 0.5, x: -4.7, z: -3.1 },
  { colour: '#0e6e78', radius: 0.42, x: -0.4, z: -3 },
  { colour: '#efe3cb', radius: 0.42, x: 7.5, z: -1.6 },
] as const;

/** Marbles between the rows. */
export function buildLobbyMarbles(paints: Paints): Group {
  const root = new Group();
  const add = placer(root, paints);
  for (const { colour, radius, x, z } of MARBLES)
    add(buildMarble(radius), colour, [x, 0, z], { finish: 'marble' });
  return root;
}

export function shadeMarbles(root: Group, shades: ContactShades): void {
  for (const { x, z, radius } of MARBLES)
    shades.add(root.position.x + x, 0, z, radius * 2.2, radius * 1.8);
}
