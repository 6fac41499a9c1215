import { Group, Mesh, type BufferGeometry } from 'three';

import type { Seat } from '../../../sim/index.ts';
import type { Paints } from '../../light/paints.ts';
import { GlyphSheet } from '../../pieces/glyph-sheet.ts';
import { disposeToys, placer, WOOD } from '../../toys/toy-box.ts';
import { buildBlock } from '../../toys/turned.ts';

/** A step of the podium: place, middle, size, units. */
interface PodiumStep {
  readonly place: 1 | 2 | 3;
  readonly x: number;
  readonly width: number;
  readonly height: number;
  readonly trim: string;
}

export const STEP_DEPTH = 3;
/** From left to right as they stand; the first in the middle. So high that the digits are above the heads of a crowd. */
export const STEPS: readonly PodiumStep[] = [
  { place: 2, x: -4.1, width: 4, height: 4.2, trim: '#dcd9d2' },
  { place: 1, x: 0, width: 4, height: 5.4, trim: '#f0b62c' },
  { place: 3, x: 4.1, width: 4, height: 3.4, trim: '#d98d58' },
];

/** Pieces per row before the steps. */
const ROW_OF_OTHERS = 10;
/** The camera looks far less down than in the lobby: rows that are nearer hide letters. */
const ROW_OF_OTHERS_Z = 5.4;
/** The first row before the steps. */
const CROWD_Z = 4.2;
/** As few stand between the digits. */
const BETWEEN_DIGITS = [-2.05, 2.05, 7.4] as const;

export interface PodiumSpot {
  readonly seat: Seat;
  /** From 1; 0 for the others. */
  readonly place: number;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly size: number;
}

/** The first three on their steps, the others in rows before them. */
export function podiumSpots(seats: readonly Seat[], first: readonly Seat[]): PodiumSpot[] {
  const winners = first.slice(0, STEPS.length).filter((seat) => seats.includes(seat));
  const others = seats.filter((seat) => !winners.includes(seat));
  // Few stand between the digits, many before them
  const isCrowd = others.length > BETWEEN_DIGITS.length;
  const rows = Math.ceil(others.length / ROW_OF_OTHERS);
  const perRow = Math.ceil(others.length / Math.max(1, rows));
  const gap = Math.min(3.3, 15 / Math.max(1, perRow));
  const size = Math.min(1, gap / 2.2);
  return [
    ...winners.map((seat, index) => {
      const step = STEPS.find(({ place }) => place === index + 1)!;
      return { seat, place: index + 1, x: step.x, y: step.height, z: 0, size: 1.28 };
    }),
    ...others.map((seat, index) => {
      const [row, column] = [Math.floor(index / perRow), index % perRow];
      const inRow = Math.min(perRow, others.length - row * perRow);
      return {
        seat,
        place: 0,
        x: !isCrowd
          ? BETWEEN_DIGITS[index]!
          : 1.3 + (column - (inRow - 1) / 2) * gap + (row % 2 === 0 ? 0 : gap * 0.25),
        y: 0,
        z: STEP_DEPTH / 2 + (isCrowd ? CROWD_Z : 1.3) + row * ROW_OF_OTHERS_Z * size,
        size,
      };
    }),
  ];
}

const INK = '#221c14';
const TRIM = 0.42;
/** The side of a digit's square, near the upper edge. */
const DIGIT = 2.3;

/** Three wooden steps with 1, 2 and 3. */
export class PodiumSteps {
  readonly root = new Group();
  readonly #digits = new GlyphSheet(['1', '2', '3']);
  readonly #signs = new Group();

  constructor(paints: Paints) {
    const add = placer(this.root, paints);
    for (const { place, x, width, height, trim } of STEPS) {
      add(buildBlock(width, height - TRIM + 0.1, STEP_DEPTH, 0.1), WOOD, [x, 0, 0]);
      add(plate(width + 0.16, STEP_DEPTH + 0.16), trim, [x, height - TRIM, 0]);
      add(buildBlock(width - 0.5, 0.08, STEP_DEPTH - 0.5, 0.03), '#efdcb8', [x, height - 0.05, 0]);
      const sign = new Mesh(this.#digits.square(place - 1), this.#digits.material(INK));
      sign.position.set(x, height - TRIM - DIGIT * 0.48, STEP_DEPTH / 2 + 0.02);
      sign.scale.setScalar(DIGIT);
      this.#signs.add(sign);
    }
    this.root.add(this.#signs);
  }

  dispose(): void {
    this.#signs.removeFromParent();
    disposeToys(this.root);
    this.#digits.dispose();
  }
}

function plate(width: number, depth: number): BufferGeometry {
  return buildBlock(width, TRIM, depth, 0.14);
}
