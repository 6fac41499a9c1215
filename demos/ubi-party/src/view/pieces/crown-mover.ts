import { Group, Mesh, Vector3 } from 'three';
import { hop, smooth } from '../motion/motion.ts';
import type { PieceKit } from './piece-kit.ts';

const HOP_S = 0.3;
const HOP_HEIGHT = 1.6;

/** The one crown: it sits on its wearer, and hops over to the next. */
export class CrownMover {
  readonly root = new Group();
  readonly #from = new Vector3();
  #sinceS = HOP_S;
  #wearer: number | undefined;
  #isPlaced = false;

  constructor(kit: PieceKit) {
    const gold = new Mesh(kit.crown.gold, kit.paints.of('#f0b90b', 'gold'));
    const pearls = new Mesh(kit.crown.pearls, kit.paints.of('#fff6e4', 'marble'));
    for (const part of [gold, pearls]) part.castShadow = true;
    this.root.add(gold, pearls);
  }

  /**
   * @param wearer a seat, or undefined for a place where it waits
   * @param at where it belongs now
   */
  update(wearer: number | undefined, at: Vector3, dtS: number, isReduced: boolean): void {
    if (wearer !== this.#wearer || !this.#isPlaced) {
      this.#from.copy(this.root.position);
      this.#sinceS = this.#isPlaced ? 0 : HOP_S;
      this.#wearer = wearer;
      this.#isPlaced = true;
    }
    this.#sinceS = Math.min(HOP_S, this.#sinceS + dtS);
    const share = isReduced ? 1 : this.#sinceS / HOP_S;
    this.root.position.lerpVectors(this.#from, at, smooth(share));
    this.root.position.y += hop(share) * HOP_HEIGHT;
    this.root.rotation.y = share * Math.PI * 2;
  }
}
