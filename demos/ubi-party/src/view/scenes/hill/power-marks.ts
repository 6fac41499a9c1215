import type { Group } from 'three';
import type { Power, Seat } from '../../../sim/index.ts';
import type { Paints } from '../../light/paints.ts';
import type { Piece } from '../../pieces/piece.ts';
import { buildPower } from '../../toys/powers.ts';
import { disposeToys } from '../../toys/toy-box.ts';

const SIZE = 0.62;

/** A small toy beside the token tells which power a piece has. At most a few have one: their toys are kept. */
export class PowerMarks {
  readonly #root: Group;
  readonly #paints: Paints;
  readonly #toys = new Map<string, Group>();

  constructor(root: Group, paints: Paints) {
    this.#root = root;
    this.#paints = paints;
  }

  begin(): void {
    for (const toy of this.#toys.values()) toy.visible = false;
  }

  set({ seat, root, body }: Piece, power: Power | undefined): void {
    if (!power) return;
    const toy = this.#toy(seat, power);
    toy.visible = true;
    // At the right of the foot, before it: the letter stays free
    toy.position.set(root.position.x + 1.15, root.position.y, root.position.z + 0.75);
    toy.rotation.z = body.rotation.z;
  }

  dispose(): void {
    for (const toy of this.#toys.values()) disposeToys(toy);
  }

  #toy(seat: Seat, power: Power): Group {
    const key = `${seat} ${power}`;
    let toy = this.#toys.get(key);
    if (!toy) {
      toy = buildPower(power, this.#paints);
      toy.scale.setScalar(SIZE);
      this.#toys.set(key, toy);
      this.#root.add(toy);
    }
    return toy;
  }
}
