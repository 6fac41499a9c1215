import { Group, Mesh, TorusGeometry } from 'three';
import { POWERS, type HillState, type Power } from '../../../sim/index.ts';
import type { Paints } from '../../light/paints.ts';
import { buildPower } from '../../toys/powers.ts';
import { disposeToys } from '../../toys/toy-box.ts';
import { PLATFORM_Y } from './platform-motion.ts';

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
