import { type BufferGeometry, type Group, type MeshStandardMaterial } from 'three';
import { identityOf, type Seat } from '../../../sim/index.ts';
import type { Paints } from '../../light/paints.ts';
import { scatter } from '../../motion/ease.ts';
import { FlyingBits } from '../../motion/flying-bits.ts';
import { buildConfetti } from '../../pieces/token-geometry.ts';

const LASTS_S = 5;
const PIECES = 260;
/** It lies there until the scene ends. */
const LIFE_S = 600;

/** Confetti in the shapes and colours of the players: it falls for five seconds, then it lies there. */
export class Confetti {
  readonly #kinds: { readonly bits: FlyingBits; readonly form: BufferGeometry }[] = [];
  #launched = 0;
  #timeS = 0;

  constructor(root: Group, paints: Paints, seats: readonly Seat[]) {
    const looks = new Map(seats.map((seat) => [identityOf(seat).shape, identityOf(seat)]));
    const each = Math.ceil(PIECES / Math.max(1, looks.size));
    for (const { shape, colour } of looks.values()) {
      const form = buildConfetti(shape);
      const paint: MeshStandardMaterial = paints.of(colour);
      const bits = new FlyingBits(root, form, paint, each, 0.85);
      // Their shadows would be far away from them
      bits.mesh.castShadow = false;
      this.#kinds.push({ form, bits });
    }
  }

  update(dtS: number): void {
    this.#timeS += dtS;
    const due = Math.floor(PIECES * Math.min(1, this.#timeS / LASTS_S));
    for (; this.#launched < due && this.#kinds.length > 0; this.#launched += 1) this.#launch();
    for (const { bits } of this.#kinds) bits.update(dtS, 0);
  }

  dispose(): void {
    for (const { bits, form } of this.#kinds) {
      bits.dispose();
      form.dispose();
    }
  }

  #launch(): void {
    const index = this.#launched;
    const at = (salt: number): number => scatter(index, salt);
    this.#kinds[index % this.#kinds.length]!.bits.launch({
      x: (at(1) - 0.5) * 24,
      y: 11 + at(2) * 4,
      z: (at(3) - 0.4) * 11,
      vx: (at(4) - 0.5) * 5,
      vy: at(5) * 3,
      vz: (at(6) - 0.5) * 4,
      size: 0.26 + at(7) * 0.26,
      lifeS: LIFE_S,
    });
  }
}
