import { Mesh, MeshBasicMaterial, RingGeometry, Group, TorusGeometry } from 'three';

import { POWERS, type Seat, type HillState, type Power } from '../../../sim/index.ts';
import type { Paints } from '../../light/paints.ts';
import type { Piece } from '../../pieces/piece.ts';
import { buildPower } from '../../toys/powers.ts';
import { disposeToys } from '../../toys/toy-box.ts';
import { PLATFORM_Y } from './platform-motion.ts';

const PARTS = 48;

/** Round the foot of a piece an arc closes while its dash charges. */
export class ChargeArcs {
  readonly #root: Group;
  readonly #arcs = new Map<Seat, Mesh<RingGeometry, MeshBasicMaterial>>();
  readonly #charging = new MeshBasicMaterial({ color: '#ffffff' });
  readonly #full = new MeshBasicMaterial({ color: '#f5a623' });

  constructor(root: Group) {
    this.#root = root;
  }

  /** @param charge 0 to 1 */
  set(seat: Seat, charge: number, x: number, y: number, z: number): void {
    let arc = this.#arcs.get(seat);
    if (charge <= 0) {
      if (arc) arc.visible = false;
      return;
    }
    if (!arc) {
      const geometry = new RingGeometry(1.08, 1.28, PARTS, 1, Math.PI / 2).rotateX(-Math.PI / 2);
      arc = new Mesh(geometry, this.#charging);
      this.#arcs.set(seat, arc);
      this.#root.add(arc);
    }
    arc.visible = true;
    arc.material = charge >= 1 ? this.#full : this.#charging;
    arc.position.set(x, y + 0.03, z);
    // Six corners a part
    arc.geometry.setDrawRange(0, Math.ceil(charge * PARTS) * 6);
  }

  dispose(): void {
    for (const arc of this.#arcs.values()) arc.geometry.dispose();
    this.#charging.dispose();
    this.#full.dispose();
  }
}

/** The power that lies on the platform, in a ring of paper. */
export class Offer {
  readonly root = new Group();
  readonly #toys: ReadonlyMap<Power, Group>;
  readonly #ring: TorusGeometry;
  #shownS = 0;

  constructor(paints: Paints) {
    this.#ring = new TorusGeometry(0.95, 0.06, 8, 48);
    this.#ring.rotateX(Math.PI / 2).translate(0, 0.05, 0);
    this.root.add(new Mesh(this.#ring, paints.of('#fff6e4')));
    this.#toys = new Map(POWERS.map((kind) => [kind, buildPower(kind, paints)]));
    for (const toy of this.#toys.values()) this.root.add(toy);
  }

  update(offer: HillState['offer'], dtS: number, isReduced: boolean): void {
    this.root.visible = offer !== undefined;
    this.#shownS = offer ? this.#shownS + dtS : 0;
    if (!offer) return;
    this.root.position.set(offer.position.x, PLATFORM_Y, -offer.position.y);
    const size = isReduced ? 1 : Math.min(1, this.#shownS * 4);
    this.root.scale.setScalar(size);
    for (const [kind, toy] of this.#toys) {
      toy.visible = kind === offer.kind;
      if (isReduced) continue;
      toy.position.y = 0.12 + 0.1 * Math.sin(this.#shownS * 3);
      toy.rotation.y = Math.sin(this.#shownS * 1.4) * 0.7;
    }
  }

  dispose(): void {
    this.#ring.dispose();
    for (const toy of this.#toys.values()) disposeToys(toy);
  }
}

const SIZE = 0.62;

/** A small toy beside the token shows which power a piece has. At most a few have one: their toys are kept. */
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
