import {
  STEP_S,
  STEPS_PER_SECOND,
  type Controls,
  type ReadControls,
  type GameSettings,
} from '../game.ts';
import { collide, clamp, dot, length, turned, type Disc } from '../plane/plane.ts';
import { trackOf, type Cart, type RaceState } from './race-state.ts';
import { findOnTrack, isOn, placeAt, type Track } from './track.ts';

/** Settings that can be changed during the race: factors of the default values. */
export interface RaceSettings extends GameSettings {
  /** Factor of the top speed of carts. */
  readonly speed: number;
  /** Factor of the grip against sliding sideways. */
  readonly grip: number;
  /** Factor of the gravity: higher makes jumps shorter. */
  readonly gravity: number;
}

/** Units per second. */
const TOP_SPEED = 13;
const BRAKED = 0.4;
const BOOSTED = 1.5;
/** Units per second squared. */
const ACCELERATION = 9;
/** Tangent of half the angle a cart turns in a step at full lock and full speed. */
const LOCK = 1.25 * STEP_S;
/** Share of the sideways speed that is lost per second. */
const GRIP = 7;
const STEPS_OF_BOOST = 1.2 * STEPS_PER_SECOND;
const STEPS_OF_JUMP = 0.55 * STEPS_PER_SECOND;
/** A cart that left the track is back within 0.8 seconds. */
const STEPS_OF_LIFT = 0.75 * STEPS_PER_SECOND;
const SECONDS_TO_FILL = 9;
/** A cart is off when its middle is so far beyond the kerb. */
const BEYOND_KERB = 0.6;
const MIN_TO_JUMP = 6;
/** Units per second; a softer touch is no hit. */
const MIN_HIT = 2;

export function stepRace(state: RaceState, controls: ReadControls, settings: RaceSettings): void {
  state.step += 1;
  const track = trackOf(state);
  for (const cart of state.carts) {
    if (cart.liftSteps > 0) lift(cart, track);
    // A cart that has finished rolls out
    else drive(cart, cart.finishedAt === undefined ? controls(cart.seat) : ROLL_OUT, settings);
  }
  for (const { a, b, speed } of collide(state.carts.filter(isOnGround).map(asDisc))) {
    if (speed > MIN_HIT) a.cart.hitAt = b.cart.hitAt = state.step;
  }
  for (const cart of state.carts) {
    if (cart.liftSteps === 0) follow(cart, track, state.step, settings);
  }
}

const ROLL_OUT: Controls = { x: 0, y: -1, isPressed: false };

function drive(cart: Cart, controls: Controls, settings: RaceSettings): void {
  boost(cart, controls);
  const { position, velocity } = cart;
  if (cart.jumpSteps > 0) cart.jumpSteps -= 1;
  else {
    const share = clamp(length(velocity) / TOP_SPEED, 0.2, 1);
    cart.heading = turned(cart.heading, -clamp(controls.x, -1, 1) * LOCK * share);
    const { heading } = cart;
    const side = { x: -heading.y, y: heading.x };
    const forward = dot(velocity, heading);
    const sideways = dot(velocity, side) * (1 - Math.min(1, GRIP * settings.grip * STEP_S));
    const isBoosted = cart.boostSteps > 0;
    const top = TOP_SPEED * settings.speed * (isBoosted ? BOOSTED : controls.y < -0.5 ? BRAKED : 1);
    const most = ACCELERATION * (isBoosted ? 3 : 1) * STEP_S;
    const ahead = forward + clamp(top - forward, -most, most);
    velocity.x = heading.x * ahead + side.x * sideways;
    velocity.y = heading.y * ahead + side.y * sideways;
  }
  position.x += velocity.x * STEP_S;
  position.y += velocity.y * STEP_S;
}

/** A press gives what was saved up; who holds the button does not press again. */
function boost(cart: Cart, { isPressed }: Controls): void {
  cart.energy = Math.min(1, cart.energy + STEP_S / SECONDS_TO_FILL);
  if (isPressed && !cart.wasPressed && cart.energy === 1) {
    cart.energy = 0;
    cart.boostSteps = STEPS_OF_BOOST;
  } else if (cart.boostSteps > 0) cart.boostSteps -= 1;
  cart.wasPressed = isPressed;
}

function isOnGround(cart: Cart): boolean {
  return cart.liftSteps === 0 && cart.jumpSteps === 0;
}

function asDisc(cart: Cart): Disc & { readonly cart: Cart } {
  const { position, velocity } = cart;
  return { cart, position, velocity, radius: 1, mass: 1, bounce: 0.5 };
}

/** Says where the cart is now, and what the track does to it. */
function follow(cart: Cart, track: Track, step: number, settings: RaceSettings): void {
  const before = cart.distance;
  Object.assign(cart, findOnTrack(track, cart.position, before));
  const finish = track.laps * track.length;
  if (cart.finishedAt === undefined && cart.distance >= finish) {
    cart.finishedAt = step - (cart.distance - finish) / Math.max(1e-9, cart.distance - before);
  }
  if (cart.jumpSteps > 0) return;
  if (Math.abs(cart.toLeft) > track.halfWidth + BEYOND_KERB) {
    cart.liftSteps = STEPS_OF_LIFT;
    cart.boostSteps = 0;
    cart.hitAt = step;
    return;
  }
  if (track.boosts.some((stretch) => isOn(stretch, track, cart.distance)))
    cart.boostSteps = STEPS_OF_BOOST;
  const crossed = (share: number): boolean => {
    const at = Math.floor(cart.distance / track.length) * track.length + share * track.length;
    return before < at && cart.distance >= at;
  };
  if (track.bridge && crossed(track.bridge.from) && length(cart.velocity) > MIN_TO_JUMP) {
    cart.jumpSteps = Math.round(STEPS_OF_JUMP / Math.max(0.2, settings.gravity));
  }
}

/** Carried to the middle of the track, where it left it, and set down facing forward. */
function lift(cart: Cart, track: Track): void {
  const { position, direction } = placeAt(track, cart.distance);
  const share = 1 / cart.liftSteps;
  cart.position.x += (position.x - cart.position.x) * share;
  cart.position.y += (position.y - cart.position.y) * share;
  cart.liftSteps -= 1;
  if (cart.liftSteps > 0) return;
  cart.heading = { ...direction };
  cart.toLeft = 0;
  cart.velocity.x = direction.x * TOP_SPEED * BRAKED;
  cart.velocity.y = direction.y * TOP_SPEED * BRAKED;
}
