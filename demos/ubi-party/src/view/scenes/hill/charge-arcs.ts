import { Mesh, MeshBasicMaterial, RingGeometry, type Group } from 'three';
import type { Seat } from '../../../sim/index.ts';

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
