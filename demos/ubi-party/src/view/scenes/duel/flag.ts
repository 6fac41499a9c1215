import {
  Color,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  type BufferGeometry,
} from 'three';
import type { Paints } from '../../light/paints.ts';
import { buildMarble, disposeToys, placer, WOOD } from '../../toys/toy-box.ts';
import { buildCylinder, buildTurned } from '../../toys/turned.ts';

const POLE = { height: 11, radius: 0.24 } as const;
const CLOTH = { width: 5.2, height: 3.4, columns: 6, rows: 4 } as const;
/** Of the kerbs: no player has this red beside this white. */
const CHECKERS = ['#e8674f', '#fff6e4'] as const;
const LOW = 0.75;
/** Amplitude of the cloth's loose edge, units. */
const WAVE = 0.34;

/** A flag on a pole: it falls at the signal. */
export class Flag {
  readonly root = new Group();
  readonly #cloth: Mesh<BufferGeometry, MeshStandardMaterial>;
  readonly #still: Float32Array;

  constructor(paints: Paints) {
    const add = placer(this.root, paints);
    add(
      buildTurned(
        [
          [0, 0],
          [2.1, 0],
          [2.1, 0.45],
          [1.2, 0.8],
          [0, 0.8],
        ],
        0.14,
      ),
      WOOD,
      [0, 0, 0],
    );
    add(buildCylinder(POLE.radius, POLE.height, 0.06), '#6b5a48', [0, 0.5, 0]);
    add(buildMarble(0.5), '#f0b90b', [0, POLE.height + 0.35, 0], { finish: 'gold' });
    const geometry = buildCloth();
    this.#still = Float32Array.from(geometry.getAttribute('position').array);
    this.#cloth = new Mesh(
      geometry,
      new MeshStandardMaterial({ vertexColors: true, roughness: 0.8, side: DoubleSide }),
    );
    this.#cloth.castShadow = true;
    this.#cloth.receiveShadow = true;
    this.root.add(this.#cloth);
  }

  /** @param height 1 at the top of the pole, 0 on the ground */
  update(height: number, timeS: number, isReduced: boolean): void {
    const top = POLE.height - CLOTH.height / 2;
    const bottom = LOW + CLOTH.height / 2;
    this.#cloth.position.set(POLE.radius, bottom + (top - bottom) * height, 0);
    // On the ground it is a heap
    this.#cloth.scale.y = 0.35 + 0.65 * Math.min(1, height * 4 + 0.15);
    this.#cloth.position.y -= (1 - this.#cloth.scale.y) * (CLOTH.height / 2) * (1 - height);
    this.#wave(isReduced ? 0 : timeS);
  }

  dispose(): void {
    this.#cloth.material.dispose();
    disposeToys(this.root);
  }

  #wave(timeS: number): void {
    const positions = this.#cloth.geometry.getAttribute('position');
    const normals = this.#cloth.geometry.getAttribute('normal');
    for (let index = 0; index < positions.count; index += 1) {
      const x = this.#still[index * 3]!;
      const y = this.#still[index * 3 + 1]!;
      const loose = x / CLOTH.width;
      const phase = x * 1.5 - timeS * 4.2 + y * 0.4;
      positions.setZ(index, Math.sin(phase) * WAVE * loose);
      positions.setY(index, y - loose * loose * 0.35);
      // Of the surface itself: faces of the cloth would be seen
      const slope = WAVE * (Math.cos(phase) * 1.5 * loose + Math.sin(phase) / CLOTH.width);
      const size = Math.hypot(slope, 1);
      normals.setXYZ(index, -slope / size, 0, 1 / size);
    }
    positions.needsUpdate = true;
    normals.needsUpdate = true;
  }
}

/** Chequered: its edge at the pole is x = 0. */
function buildCloth(): BufferGeometry {
  const parts = 3;
  const plane = new PlaneGeometry(
    CLOTH.width,
    CLOTH.height,
    CLOTH.columns * parts,
    CLOTH.rows,
  ).translate(CLOTH.width / 2, 0, 0);
  const flat = plane.toNonIndexed();
  plane.dispose();
  flat.deleteAttribute('uv');
  const positions = flat.getAttribute('position');
  const colours = new Float32Array(positions.count * 3);
  const colour = new Color();
  for (let face = 0; face < positions.count; face += 3) {
    const middle = (axis: 'getX' | 'getY'): number =>
      (positions[axis](face) + positions[axis](face + 1) + positions[axis](face + 2)) / 3;
    const column = Math.floor((middle('getX') / CLOTH.width) * CLOTH.columns);
    const row = Math.floor((middle('getY') / CLOTH.height + 0.5) * CLOTH.rows);
    colour.set(CHECKERS[(column + row) % 2]!);
    for (let corner = 0; corner < 3; corner += 1) colour.toArray(colours, (face + corner) * 3);
  }
  flat.setAttribute('color', new Float32BufferAttribute(colours, 3));
  return flat;
}
