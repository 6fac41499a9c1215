import type { Group, Vector3 } from 'three';

import type { Seat } from '../../sim/index.ts';
import type { Frame } from '../camera/camera-rig.ts';
import type { ContactShades } from '../light/ground-shade.ts';
import { hop, approach, clamp01, scatter, Spring } from '../motion/motion.ts';
import type { PieceKit } from './piece-kit.ts';
import { PieceSet, type Piece, type Stand } from './piece.ts';

const FROM_Y = 10;
const GRAVITY = 44;
/** Seconds until it touches the table. */
export const FALL_S = Math.sqrt((2 * FROM_Y) / GRAVITY);
const BOUNCE = { lastsS: 0.36, height: 0.8 } as const;
/** From here on it stands still. */
export const DROP_S = FALL_S + BOUNCE.lastsS;

/** Height of a piece that joins: it drops in, bounces once, and stands. @param sinceS seconds since it came */
export function dropHeight(sinceS: number): number {
  if (sinceS <= 0) return FROM_Y;
  if (sinceS < FALL_S) return FROM_Y - (GRAVITY * sinceS * sinceS) / 2;
  return hop((sinceS - FALL_S) / BOUNCE.lastsS) * BOUNCE.height;
}

/** Whether it touches the table between two times. */
export function touchesDown(beforeS: number, nowS: number): boolean {
  return [FALL_S, DROP_S].some((at) => beforeS < at && nowS >= at);
}

/** Position and posture of a piece. Units, on the table. */
export interface Standing {
  readonly seat: Seat;
  readonly x: number;
  readonly z: number;
  /** Of what it stands on. */
  readonly y: number;
  readonly yaw: number;
  readonly size: number;
  /** The piece of an absent player lies down. */
  readonly isLying: boolean;
}

interface Actor {
  readonly piece: Piece;
  readonly lying: Spring;
  sinceS: number;
  /** Seconds since a hop began. */
  hopS: number;
  hopHeight: number;
  goal: Standing;
  isLeaving: boolean;
  leftS: number;
}

const HOP_S = 0.5;
const LEAVE_S = 0.9;
/** Lying on its back. */
const ON_BACK = -1.35;
const TILT = -0.07;

/** Pieces that stand on a table: they drop in, go to their places, hop, lie down and leave. */
export class StandingPieces {
  readonly #set: PieceSet;
  readonly #actors = new Map<Seat, Actor>();

  constructor(root: Group, kit: PieceKit, stand: Stand) {
    this.#set = new PieceSet(root, kit, stand);
  }

  /** @param drops whether new pieces drop in */
  show(standings: readonly Standing[], drops: boolean): void {
    const seats = new Set<Seat>();
    for (const goal of standings) {
      seats.add(goal.seat);
      const actor = this.#actors.get(goal.seat);
      if (actor) Object.assign(actor, { goal, isLeaving: false, leftS: 0 });
      else this.#add(goal, drops);
    }
    for (const [seat, actor] of this.#actors) actor.isLeaving ||= !seats.has(seat);
  }

  /** Lets a piece hop, when it does not do so already. */
  hop(seat: Seat, height: number): void {
    const actor = this.#actors.get(seat);
    if (!actor || actor.hopS < HOP_S) return;
    actor.hopS = 0;
    actor.hopHeight = height;
  }

  hit(seat: Seat, share: number): void {
    this.#actors.get(seat)?.piece.hit(share);
  }

  find(seat: Seat): Piece | undefined {
    return this.#set.find(seat);
  }

  /** @returns whether something moves */
  update(frame: Frame, shades: ContactShades): void {
    for (const [seat, actor] of this.#actors) {
      if (actor.isLeaving) actor.leftS += frame.dtS;
      if (actor.leftS > (frame.isReduced ? 0 : LEAVE_S)) {
        this.#actors.delete(seat);
        this.#set.keep(new Set(this.#actors.keys()));
        continue;
      }
      this.#move(actor, frame);
      const { x, z } = actor.piece.root.position;
      const { y, size } = actor.goal;
      const isLow = actor.piece.root.position.y - y < 1.2;
      const isUp = actor.lying.value < 0.5;
      if (isLow) shades.add(x, y, isUp ? z : z - 1.1 * size, 2.5 * size, (isUp ? 1.5 : 3.2) * size);
    }
  }

  /** @returns units from the foot to the top of the token; 0 when the piece is not there */
  footOf(seat: Seat, into: Vector3): number {
    const actor = this.#actors.get(seat);
    if (!actor) return 0;
    const { position } = actor.piece.root;
    // The name stays on the table while its piece hops
    const front = actor.piece.hasFoot ? 0.9 * actor.goal.size : 0.3;
    into.set(position.x, actor.goal.y, position.z + front);
    return actor.piece.height * actor.goal.size;
  }

  #add(goal: Standing, drops: boolean): void {
    const piece = this.#set.get(goal.seat);
    piece.root.position.set(goal.x, goal.y, goal.z);
    piece.root.scale.setScalar(goal.size);
    this.#actors.set(goal.seat, {
      piece,
      goal,
      lying: new Spring(goal.isLying ? 1 : 0, 90, 13),
      sinceS: drops ? 0 : DROP_S,
      hopS: HOP_S,
      hopHeight: 0,
      isLeaving: false,
      leftS: 0,
    });
  }

  #move(actor: Actor, { dtS, isReduced }: Frame): void {
    const { piece, goal, lying } = actor;
    const before = actor.sinceS;
    actor.sinceS = isReduced ? DROP_S : before + dtS;
    if (!isReduced && touchesDown(before, actor.sinceS)) piece.hit(before < 0.7 ? 1.2 : 0.6);
    const wasUp = actor.hopS < HOP_S;
    actor.hopS += dtS;
    const isUp = actor.hopS < HOP_S && !isReduced;
    if (wasUp && !isUp && !isReduced) piece.hit(0.8);
    const hopShare = clamp01(actor.hopS / HOP_S);
    const hopping = isUp ? 4 * hopShare * (1 - hopShare) * actor.hopHeight : 0;

    const share = isReduced ? 1 : approach(dtS, 0.12);
    const { position, scale } = piece.root;
    position.x += (goal.x - position.x) * share;
    position.z += (goal.z - position.z) * share;
    position.y = goal.y + dropHeight(actor.sinceS) + hopping;
    const size = goal.size * (1 - clamp01((actor.leftS - 0.5) / 0.4));
    scale.setScalar(scale.x + (size - scale.x) * (actor.leftS > 0.5 ? 1 : share));

    const isDown = goal.isLying || actor.isLeaving;
    if (isReduced) lying.set(isDown ? 1 : 0);
    else lying.step(isDown ? 1 : 0, dtS);
    piece.settle(dtS, 0, isUp ? Math.sin(hopShare * Math.PI * 2) * 0.1 : 0, isReduced);
    const down = Math.max(0, lying.value);
    piece.root.rotation.set(down * ON_BACK, goal.yaw * (1 - down * 0.4), 0, 'YXZ');
    piece.token.rotation.x = TILT * (1 - down);
    // On its back it lies on half of its depth
    position.y += down * 0.3 * goal.size;
  }
}

/** A small turn of its own for each seat: pieces are not aligned exactly. */
export function yawOf(seat: Seat, most = 0.2): number {
  return (scatter(seat, 7) - 0.5) * 2 * most;
}
