import type { BufferGeometry } from 'three';
import { identityOf, MAX_SEATS, type Seat, type Shape } from '../../sim/index.ts';
import { Paints } from '../light/paints.ts';
import { buildFoot, buildFootRing, buildNeck, buildCrown } from '../toys/piece-parts.ts';
import { GlyphSheet } from './glyph-sheet.ts';
import { buildToken } from './token-geometry.ts';

/** Resources of all scenes: paints, letters and geometries of the pieces. Created once, disposed with the stage. */
export class PieceKit {
  readonly paints = new Paints();
  /** By seat. */
  readonly letters = new GlyphSheet(
    Array.from({ length: MAX_SEATS }, (_, seat) => identityOf(seat).letter),
  );
  readonly foot = buildFoot();
  readonly neck = buildNeck();
  readonly footRing = buildFootRing();
  readonly crown = buildCrown();
  readonly #tokens = new Map<Shape, BufferGeometry>();

  /** The token of a seat, with its bounding box. */
  token(seat: Seat): BufferGeometry {
    const { shape } = identityOf(seat);
    let token = this.#tokens.get(shape);
    if (!token) {
      token = buildToken(shape);
      token.computeBoundingBox();
      this.#tokens.set(shape, token);
    }
    return token;
  }

  dispose(): void {
    this.paints.dispose();
    this.letters.dispose();
    for (const part of [this.foot, this.neck, this.footRing, ...Object.values(this.crown)]) {
      part.dispose();
    }
    for (const token of this.#tokens.values()) token.dispose();
  }
}
