import {
  CylinderGeometry,
  Group,
  Mesh,
  SphereGeometry,
  type BufferGeometry,
  type Vector3,
} from 'three';

import {
  identityOf,
  placeAt,
  STEP_S,
  type Seat,
  type Cart,
  type Track,
} from '../../../sim/index.ts';
import type { Paints } from '../../light/paints.ts';
import { approach, hop, mix, scatter } from '../../motion/motion.ts';
import type { PieceKit } from '../../pieces/piece-kit.ts';
import { Piece } from '../../pieces/piece.ts';
import { merged } from '../../toys/piece-parts.ts';
import { WOOD } from '../../toys/toy-box.ts';
import { buildBlock } from '../../toys/turned.ts';
import type { Frame } from '../scene-view.ts';
import type { CrowdStand } from './crowd.ts';
import { duckOf, roadHeight, underpassOf } from './road.ts';

const WHEEL = 0.66;
/** Height at which the token stands, units. */
const SEAT_Y = 1.45;

/** The forms of a cart: it points along +x, its wheels stand on y = 0. */
interface CartForms {
  readonly body: BufferGeometry;
  readonly axle: BufferGeometry;
  readonly hubs: BufferGeometry;
  /** One unit high, from y = 0. */
  readonly mast: BufferGeometry;
}

function buildCartForms(): CartForms {
  const body = merged([
    buildBlock(3.7, 0.62, 1.7, 0.2).translate(0, 0.55, 0),
    buildBlock(1.9, 0.42, 1.45, 0.16).translate(-0.45, 1.08, 0),
    buildBlock(0.5, 0.5, 1.9, 0.16).translate(1.75, 0.5, 0),
  ]);
  const sides = [-1, 1] as const;
  const axle = merged(
    sides.map((side) => new SphereGeometry(WHEEL, 24, 18).translate(0, 0, side * 1.05)),
  );
  const hubs = merged(
    sides.map((side) => new SphereGeometry(0.26, 14, 10).translate(0, 0, side * 1.5)),
  );
  const mast = new CylinderGeometry(0.2, 0.24, 1, 14).translate(0, 0.5, 0);
  return { body, axle, hubs, mast };
}

/** A cart in the colour of a seat, on four marbles. */
class CartModel {
  /** Turns with the heading. */
  readonly root = new Group();
  readonly #axles: readonly Group[];
  readonly #mast: Mesh;

  constructor(seat: Seat, forms: CartForms, paints: Paints) {
    const { colour } = identityOf(seat);
    // A black cart is seen by its marbles
    const [tyre, hub] = colour === '#221c14' ? ['#fff6e4', '#221c14'] : ['#221c14', '#fff6e4'];
    const body = new Mesh(forms.body, paints.of(colour));
    this.#axles = [-1.15, 1.15].map((x) => {
      const axle = new Group();
      axle.position.set(x, WHEEL, 0);
      axle.add(
        new Mesh(forms.axle, paints.of(tyre!, 'marble')),
        new Mesh(forms.hubs, paints.of(hub!)),
      );
      return axle;
    });
    this.#mast = new Mesh(forms.mast, paints.of(WOOD));
    this.#mast.position.y = SEAT_Y - 0.2;
    this.root.add(body, this.#mast, ...this.#axles);
    this.root.traverse((part) => {
      part.castShadow = true;
      part.receiveShadow = true;
    });
  }

  /** Puts the token on a mast. @param height units above the seat */
  raise(height: number): void {
    this.#mast.visible = height > 0.05;
    this.#mast.scale.y = height + 0.4;
  }

  /** @param distance units driven */
  roll(distance: number): void {
    for (const axle of this.#axles) axle.rotation.z = -distance / WHEEL;
  }
}

/** Tokens are as large as the road is wide: a circuit fits the picture, and they are still read from afar. */
const TOKEN = 2.55;
/** Seconds for half of the way when a crowd gathers or parts. */
const SPREAD_S = 0.22;
const CART = 1.18;
const JUMP_HEIGHT = 2.6;
const LIFT_HEIGHT = 5;
const LIFT_STEPS = 45;
/** Lying back, so that it passes below the bridge. */
const DUCKED = -1.25;

interface Driver {
  readonly root: Group;
  readonly cart: CartModel;
  readonly piece: Piece;
  jumpOf: number;
  yaw: number;
  /** Smoothed: what a crowd makes of its token. */
  size: number;
  lift: number;
}

/** The carts with their tokens. */
export class RaceCarts {
  readonly #root: Group;
  readonly #kit: PieceKit;
  readonly #forms: CartForms = buildCartForms();
  readonly #drivers = new Map<Seat, Driver>();
  readonly #track: Track;
  readonly #underpass: number | undefined;

  constructor(root: Group, kit: PieceKit, track: Track) {
    this.#root = root;
    this.#kit = kit;
    this.#track = track;
    this.#underpass = underpassOf(track);
  }

  keep(seats: ReadonlySet<Seat>): void {
    for (const [seat, { root }] of this.#drivers) {
      if (seats.has(seat)) continue;
      root.removeFromParent();
      this.#drivers.delete(seat);
    }
  }

  piece(seat: Seat): Piece | undefined {
    return this.#drivers.get(seat)?.piece;
  }

  /** Moves a cart on. @param aheadS seconds from its state to the frame */
  place(one: Cart, stand: CrowdStand, aheadS: number, frame: Frame): Vector3 {
    const driver = this.#driver(one, stand);
    const { root, cart, piece } = driver;
    const isLifted = one.liftSteps > 0;
    const ahead = isLifted ? 0 : aheadS;
    const distance = one.distance + ahead * Math.hypot(one.velocity.x, one.velocity.y);
    root.position.set(
      one.position.x + one.velocity.x * ahead,
      roadHeight(this.#track, distance) + this.#airOf(driver, one, frame.isReduced, ahead),
      -(one.position.y + one.velocity.y * ahead),
    );
    cart.root.rotation.y = this.#yawOf(driver, one);
    cart.root.rotation.z = one.jumpSteps > 0 ? (one.jumpSteps / driver.jumpOf - 0.5) * 0.5 : 0;
    cart.roll(distance);

    const share = frame.isReduced ? 1 : approach(frame.dtS, SPREAD_S);
    driver.size += (stand.size - driver.size) * share;
    driver.lift += (stand.lift - driver.lift) * share;
    piece.root.scale.setScalar(TOKEN * driver.size);
    const bend = -one.velocity.x * 0.006;
    piece.settle(frame.dtS, 0, bend, frame.isReduced);
    const isBelow = roadHeight(this.#track, distance) < 1;
    const duck = isBelow ? duckOf(this.#track, this.#underpass, distance) : 0;
    piece.root.rotation.x = duck * DUCKED;
    const { x, z } = root.position;
    piece.token.rotation.set(-0.1, Math.atan2(frame.eye.x - x, frame.eye.z - z), 0, 'YXZ');
    const lift = driver.lift * (1 - duck);
    cart.raise(lift / CART);
    piece.root.position.y = SEAT_Y * CART + lift;
    return root.position;
  }

  dispose(): void {
    for (const form of Object.values(this.#forms)) form.dispose();
  }

  /** Above the road, units: a jump, a lift back onto the track, and the trembling of the wheels. */
  #airOf(driver: Driver, one: Cart, isReduced: boolean, ahead: number): number {
    if (one.jumpSteps > driver.jumpOf || one.jumpSteps === 0)
      driver.jumpOf = Math.max(1, one.jumpSteps);
    if (one.jumpSteps > 0) {
      const left = one.jumpSteps - ahead / STEP_S;
      return hop(1 - left / driver.jumpOf) * JUMP_HEIGHT;
    }
    if (one.liftSteps > 0) return hop(1 - one.liftSteps / LIFT_STEPS) * LIFT_HEIGHT;
    return isReduced ? 0 : Math.abs(Math.sin(one.distance * 1.7 + one.seat)) * 0.05;
  }

  /** Yaw of a cart; while it is lifted, it turns to the direction of the track. */
  #yawOf(driver: Driver, one: Cart): number {
    const heading = Math.atan2(one.heading.y, one.heading.x);
    if (one.liftSteps === 0) {
      driver.yaw = heading;
      return heading;
    }
    const { direction } = placeAt(this.#track, one.distance);
    const goal = Math.atan2(direction.y, direction.x);
    const turn = Math.atan2(Math.sin(goal - driver.yaw), Math.cos(goal - driver.yaw));
    return driver.yaw + mix(0, turn, 1 - one.liftSteps / LIFT_STEPS);
  }

  #driver({ seat }: Cart, { size, lift }: CrowdStand): Driver {
    let driver = this.#drivers.get(seat);
    if (!driver) {
      const root = new Group();
      const cart = new CartModel(seat, this.#forms, this.#kit.paints);
      cart.root.scale.setScalar(CART);
      const piece = new Piece(seat, this.#kit, 'table');
      root.add(cart.root, piece.root);
      this.#root.add(root);
      driver = { root, cart, piece, jumpOf: 1, yaw: scatter(seat, 1), size, lift };
      this.#drivers.set(seat, driver);
    }
    return driver;
  }
}
