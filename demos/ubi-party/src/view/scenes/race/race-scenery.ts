import {
  Color,
  CylinderGeometry,
  Group,
  InstancedMesh,
  Matrix4,
  SphereGeometry,
  type BufferGeometry,
} from 'three';
import { placeAt, type Track } from '../../../sim/index.ts';
import type { Paints } from '../../light/paints.ts';
import { scatter } from '../../motion/motion.ts';
import { merged } from '../../toys/piece-parts.ts';
import { buildArch, buildMarble, disposeToys, placer, WOOD } from '../../toys/toy-box.ts';
import { buildBlock, buildCone, buildCylinder, buildTurned } from '../../toys/turned.ts';
import { beside } from './road.ts';
import { boundsOf, freeSpots, offRoad, pillarsOf, type Spot } from './scenery.ts';

const GREENS = ['#3a9158', '#2f8350', '#4aa062'] as const;
const FANS = ['#a9c93a', '#8a5a3b', '#7cc8f0', '#fff6e4', '#7a3b8f', '#e8843c'] as const;
type Taken = (Spot & { readonly radius: number })[];

/** Arch, trees, stand and towers round a track. */
export class RaceScenery {
  readonly root = new Group();
  /** For contact shade: middle and size. */
  readonly shades: { readonly x: number; readonly z: number; readonly size: number }[] = [];
  readonly #instances: InstancedMesh[] = [];
  readonly #paints: Paints;

  constructor(track: Track, paints: Paints) {
    this.#paints = paints;
    const taken: Taken = [];
    this.#addArch(track);
    this.#addPillars(track);
    this.#addStand(track, taken);
    this.#addTowers(track, taken);
    this.#addTrees(track, taken);
    this.#addPencil(track);
  }

  dispose(): void {
    for (const mesh of this.#instances) mesh.dispose();
    disposeToys(this.root);
  }

  /** Behind the start line: it hides no cart on the grid. */
  #addArch(track: Track): void {
    const at = 3.2;
    const { direction } = placeAt(track, at);
    const width = (track.halfWidth + 2.2) * 2;
    const add = placer(this.root, this.#paints);
    const [x, , z] = beside(track, at, 0);
    const turn = Math.atan2(direction.y, direction.x) - Math.PI / 2;
    const arch = add(buildArch(width, width * 0.72, 1.5, 1.5), WOOD, [x, 0, z], { turn });
    // Black and white over the carts, as on the ground
    const shoulder = width * 0.72 - width / 2;
    for (let index = 0; index < 7; index += 1) {
      const angle = ((index + 1.5) / 9) * Math.PI;
      const stone = add(
        buildBlock(1.5, 0.95, 1.62, 0.05).translate(0, -0.475, 0),
        index % 2 === 0 ? '#221c14' : '#fff6e4',
        [0, 0, 0],
      );
      const radius = width / 2 - 0.75;
      stone.position.set(Math.cos(angle) * radius, shoulder + Math.sin(angle) * radius, 0);
      stone.rotation.z = angle - Math.PI / 2;
      arch.add(stone);
    }
  }

  #addPillars(track: Track): void {
    const pillars = pillarsOf(track);
    if (pillars.length === 0) return;
    const mesh = this.#instance(buildBlock(0.9, 1, 0.9, 0.08), WOOD, pillars.length);
    const matrix = new Matrix4();
    for (const [index, { x, y, height }] of pillars.entries()) {
      mesh.setMatrixAt(index, matrix.makeScale(1, height, 1).setPosition(x, 0, -y));
      this.shades.push({ x, z: -y, size: 2.2 });
    }
  }

  #addTrees(track: Track, taken: Taken): void {
    const spots = freeSpots(track, { count: 15, radius: 1.9, height: 4.6, salt: 11 }, taken);
    const crown = this.#instance(
      buildCone(1.85, 4.4, 0.12).translate(0, 0.9, 0),
      '#ffffff',
      spots.length,
    );
    const trunk = this.#instance(
      new CylinderGeometry(0.42, 0.5, 1, 16).translate(0, 0.5, 0),
      '#8b5e3c',
      spots.length,
    );
    const [matrix, tint] = [new Matrix4(), new Color()];
    for (const [index, { x, y }] of spots.entries()) {
      const size = 0.85 + 0.4 * scatter(index, 60);
      matrix.makeScale(size, size, size).setPosition(x, 0, -y);
      crown.setMatrixAt(index, matrix);
      crown.setColorAt(index, tint.set(GREENS[index % GREENS.length]!));
      trunk.setMatrixAt(index, matrix);
      this.shades.push({ x, z: -y, size: 4.4 * size });
    }
  }

  /** A pencil at the front right shows the scale of the scene. */
  #addPencil(track: Track): void {
    const { maxX, minY } = boundsOf(track);
    const pencil = new Group();
    const add = placer(pencil, this.#paints);
    const rod = (length: number, from: number, sides: number, radius = 1): BufferGeometry =>
      new CylinderGeometry(radius, radius, length, sides)
        .rotateZ(Math.PI / 2)
        .translate(from + length / 2, 0, 0);
    add(rod(26, 2.6, 6), '#e3a21a', [0, 0, 0]);
    add(rod(1.7, 1, 24, 1.02), '#c9c3b4', [0, 0, 0]);
    add(rod(1.1, 0, 24, 0.92), '#ec8f86', [0, 0, 0]);
    pencil.position.set(maxX - 14, 0.88, -minY + 3.4);
    pencil.rotation.y = 0.14;
    this.root.add(pencil);
  }

  /** Behind the track at the right, with those who watch. */
  #addStand(track: Track, taken: Taken): void {
    const { maxX, maxY } = boundsOf(track);
    const spot = { x: maxX - 8, y: maxY - 1 };
    while (offRoad(track, { x: spot.x, y: spot.y - 3 }) < 5) spot.y += 0.5;
    taken.push({ ...spot, radius: 8 });
    const add = placer(this.root, this.#paints);
    const fans: Spot3[] = [];
    for (let row = 0; row < 3; row += 1) {
      const [height, z] = [1.1 + row * 1.2, -spot.y - row * 2];
      add(buildBlock(13, height, 2, 0.1), WOOD, [spot.x, 0, z]);
      for (let seat = 0; seat < 7; seat += 1) {
        if (scatter(seat, row + 70) < 0.18) continue;
        fans.push({
          x: spot.x + (seat - 3) * 1.75 + (scatter(seat, row) - 0.5) * 0.4,
          y: height,
          z,
        });
      }
    }
    this.shades.push({ x: spot.x, z: -spot.y - 1.5, size: 17 });
    this.#addFans(fans);
  }

  #addFans(fans: readonly Spot3[]): void {
    const heads = this.#instance(
      new SphereGeometry(0.46, 20, 14).translate(0, 1.75, 0),
      '#e8c79a',
      fans.length,
    );
    const bodies = FANS.map((colour, kind) => {
      const of = fans.filter((_, index) => index % FANS.length === kind);
      return { of, mesh: this.#instance(fanBody(), colour, of.length) };
    });
    const matrix = new Matrix4();
    for (const [index, { x, y, z }] of fans.entries())
      heads.setMatrixAt(index, matrix.makeTranslation(x, y, z));
    for (const { of, mesh } of bodies) {
      for (const [index, { x, y, z }] of of.entries())
        mesh.setMatrixAt(index, matrix.makeTranslation(x, y, z));
    }
  }

  /** Inside of the bends, where there is room. */
  #addTowers(track: Track, taken: Taken): void {
    const add = placer(this.root, this.#paints);
    const [tower] = freeSpots(track, { count: 1, radius: 3, height: 5.5, salt: 31 }, taken);
    if (tower) {
      add(buildCylinder(2.1, 4, 0.12), '#4f84b8', [tower.x, 0, -tower.y]);
      add(buildCone(2.9, 3, 0.14), '#e2694f', [tower.x, 4, -tower.y]);
      this.shades.push({ x: tower.x, z: -tower.y, size: 7 });
    }
    const [stack] = freeSpots(track, { count: 1, radius: 2.6, height: 5, salt: 47 }, taken);
    if (!stack) return;
    const z = -stack.y;
    add(buildBlock(3.2, 2.6, 3.2, 0.14), WOOD, [stack.x, 0, z], { turn: 0.4 });
    add(buildBlock(2.2, 2.2, 2.2, 0.12), '#d9772f', [stack.x, 2.6, z], { turn: 0.1 });
    add(buildMarble(1.1), '#e9dfc8', [stack.x, 4.8, z], { finish: 'marble' });
    this.shades.push({ x: stack.x, z, size: 6 });
  }

  #instance(geometry: BufferGeometry, colour: string, count: number): InstancedMesh {
    const mesh = new InstancedMesh(geometry, this.#paints.of(colour), count);
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    mesh.frustumCulled = false;
    this.#instances.push(mesh);
    this.root.add(mesh);
    return mesh;
  }
}

interface Spot3 {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

function fanBody(): BufferGeometry {
  return merged([
    buildTurned(
      [
        [0, 0],
        [0.62, 0],
        [0.3, 1.45],
        [0, 1.45],
      ],
      0.08,
      20,
    ),
  ]);
}
