import { Group } from 'three';
import type { Paints } from '../../light/paints.ts';
import { buildArch, buildMarble, placer, WOOD } from '../../toys/toy-box.ts';
import { buildBlock, buildCone, buildCylinder } from '../../toys/turned.ts';

/** A small town of blocks behind the duel, in colours that no player has. */
export function buildDuelProps(paints: Paints): Group {
  const root = new Group();
  const add = placer(root, paints);
  add(buildArch(5.2, 5.4, 1.8, 1.3), WOOD, [-11.5, 0, -10.5], { turn: 0.25 });
  add(buildBlock(3, 3, 3, 0.14), '#d9a06b', [-16, 0, -9], { turn: 0.2 });
  add(buildBlock(2.1, 2.1, 2.1, 0.12), '#b9c7c4', [-16, 3, -9], { turn: -0.3 });
  add(buildCylinder(1.5, 4.4, 0.14), '#a9b8b8', [12, 0, -10.5]);
  add(buildCone(2.1, 2.6, 0.14), '#d9835f', [12, 4.4, -10.5]);
  add(buildBlock(3.4, 2.6, 2.6, 0.14), WOOD, [16.4, 0, -9.2], { turn: -0.24 });
  add(buildMarble(1.15), '#c9b38e', [16.4, 2.6, -9.2], { finish: 'marble' });
  add(buildMarble(0.6), '#b9c7c4', [-7.6, 0, -5.5], { finish: 'marble' });
  return root;
}
