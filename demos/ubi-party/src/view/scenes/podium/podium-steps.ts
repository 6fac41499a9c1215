import { Group, Mesh, type BufferGeometry } from 'three';
import type { Paints } from '../../light/paints.ts';
import { GlyphSheet } from '../../pieces/glyph-sheet.ts';
import { disposeToys, placer, WOOD } from '../../toys/toy-box.ts';
import { buildBlock } from '../../toys/turned.ts';
import { STEP_DEPTH, STEPS } from './podium-spots.ts';

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
