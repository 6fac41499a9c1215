import { BoxGeometry, MeshStandardMaterial, SphereGeometry, type Group } from 'three';

import { identityOf, type Cart, type RaceState, type Seat } from '../../../sim/index.ts';
import { FlyingBits, PulseRings } from '../../motion/effects.ts';
import { scatter } from '../../motion/motion.ts';
import type { Frame } from '../scene-view.ts';

/** An event of the race. */
export type RaceEvent = {
  readonly type: 'hit' | 'boost' | 'jump' | 'lift' | 'finish';
  readonly seat: Seat;
};

/** Copy of the compared values of a state, which the game changes in place. */
export interface RaceGlance {
  readonly step: number;
  readonly carts: ReadonlyMap<
    Seat,
    Pick<Cart, 'hitAt' | 'boostSteps' | 'jumpSteps' | 'liftSteps' | 'finishedAt'>
  >;
}

export function glanceAtRace(state: RaceState): RaceGlance {
  return {
    step: state.step,
    carts: new Map(
      state.carts.map(({ seat, hitAt, boostSteps, jumpSteps, liftSteps, finishedAt }) => [
        seat,
        { hitAt, boostSteps, jumpSteps, liftSteps, finishedAt },
      ]),
    ),
  };
}

/** Events between two states of a round; none when the second is of an earlier time, as in a replay. */
export function raceEvents(before: RaceGlance, state: RaceState): RaceEvent[] {
  if (state.step < before.step) return [];
  return state.carts.flatMap((cart) => {
    const known = before.carts.get(cart.seat);
    if (!known) return [];
    const { seat } = cart;
    const events: RaceEvent[] = [];
    if (cart.liftSteps > known.liftSteps) events.push({ type: 'lift', seat });
    // Leaving the track counts as a hit in the rules, for the phone
    else if (cart.hitAt > known.hitAt) events.push({ type: 'hit', seat });
    if (cart.boostSteps > 0 && known.boostSteps === 0) events.push({ type: 'boost', seat });
    if (cart.jumpSteps > known.jumpSteps) events.push({ type: 'jump', seat });
    if (cart.finishedAt !== undefined && known.finishedAt === undefined)
      events.push({ type: 'finish', seat });
    return events;
  });
}

/** The leading seat: the earliest at the finish, else the one furthest along. */
export function leaderOf({ carts }: RaceState): Seat | undefined {
  let best: Cart | undefined;
  for (const cart of carts) if (!best || isBefore(cart, best)) best = cart;
  return best?.seat;
}

function isBefore(a: Cart, b: Cart): boolean {
  if (a.finishedAt !== undefined || b.finishedAt !== undefined)
    return (a.finishedAt ?? Infinity) < (b.finishedAt ?? Infinity);
  return a.distance > b.distance;
}

const YELLOW = '#f2b93b';
const PUFF = '#efe6d2';
/** Seconds between two bits of a cart. */
const EVERY_S = { boost: 0.03, puff: 0.16 } as const;
const CHIPS_OF_A_HIT = 10;

/** Particles of the carts: blocks of a boost, puffs of the wheels, chips of a hit. */
export class RaceBits {
  readonly #paint = new MeshStandardMaterial({ roughness: 0.7 });
  readonly #block = new BoxGeometry(1, 0.8, 0.6);
  readonly #ball = new SphereGeometry(0.5, 12, 8);
  readonly #blocks: FlyingBits;
  readonly #puffs: FlyingBits;
  readonly #rings: PulseRings;
  readonly #dueS = new Map<Seat, number>();
  #count = 0;

  constructor(root: Group) {
    this.#blocks = new FlyingBits(root, this.#block, this.#paint, 260);
    this.#puffs = new FlyingBits(root, this.#ball, this.#paint, 120);
    this.#rings = new PulseRings(root, PUFF);
  }

  /** Behind a cart, as long as it drives. @param y of its wheels */
  trail(cart: Cart, y: number, { dtS, isReduced }: Frame): void {
    const speed = Math.hypot(cart.velocity.x, cart.velocity.y);
    if (isReduced || speed < 4 || cart.liftSteps > 0 || cart.jumpSteps > 0) return;
    const isBoosted = cart.boostSteps > 0;
    const every = isBoosted ? EVERY_S.boost : EVERY_S.puff;
    let due = (this.#dueS.get(cart.seat) ?? every * scatter(cart.seat, 2)) - dtS;
    for (; due <= 0; due += every) this.#launch(cart, y, isBoosted);
    this.#dueS.set(cart.seat, due);
  }

  hit(cart: Cart, y: number, isReduced: boolean): void {
    if (isReduced) {
      this.#rings.launch(cart.position.x, y, -cart.position.y);
      return;
    }
    const { colour } = identityOf(cart.seat);
    for (let chip = 0; chip < CHIPS_OF_A_HIT; chip += 1) {
      const angle = scatter(chip, cart.hitAt) * Math.PI * 2;
      this.#blocks.launch(
        {
          x: cart.position.x,
          y: y + 1,
          z: -cart.position.y - 1,
          vx: Math.cos(angle) * 5,
          vy: 6 + 5 * scatter(chip, 3),
          vz: -2 - Math.abs(Math.sin(angle)) * 4,
          size: 0.4 + 0.3 * scatter(chip, 4),
          lifeS: 0.9,
        },
        chip % 4 === 3 ? PUFF : colour,
      );
    }
  }

  update(dtS: number): void {
    this.#blocks.update(dtS, 0.25);
    this.#puffs.update(dtS, 0.25);
    this.#rings.update(dtS);
  }

  dispose(): void {
    for (const part of [this.#blocks, this.#puffs, this.#rings, this.#paint]) part.dispose();
    this.#block.dispose();
    this.#ball.dispose();
  }

  #launch({ seat, position, heading }: Cart, y: number, isBoosted: boolean): void {
    const at = (salt: number): number => scatter(this.#count, salt) - 0.5;
    this.#count += 1;
    const back = 2.2 + at(1);
    const start = {
      x: position.x - heading.x * back + at(2) * 1.6,
      y: y + (isBoosted ? 0.7 : 0.3),
      z: -(position.y - heading.y * back) + at(3) * 1.6,
      vx: -heading.x * 4 + at(4) * 5,
      vy: isBoosted ? 4 + at(5) * 4 : 1.5,
      vz: heading.y * 4 + at(6) * 5,
      size: isBoosted ? 0.5 + at(7) * 0.3 : 0.55 + at(7) * 0.4,
      lifeS: isBoosted ? 0.4 : 0.7,
    };
    if (!isBoosted) this.#puffs.launch(start, PUFF);
    else this.#blocks.launch(start, this.#count % 2 === 0 ? YELLOW : identityOf(seat).colour);
  }
}
