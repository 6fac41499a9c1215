import { STEPS_PER_SECOND, type RoundSetup, type Seat } from '../game.ts';
import type { Vector } from '../plane/plane.ts';
import { randomState, type WithRandom } from '../random.ts';

/** Powers that a piece can pick up. */
export const POWERS = ['spring', 'anchor', 'feather'] as const;
/** spring: pushes harder; anchor: is hard to push; feather: is faster. */
export type Power = (typeof POWERS)[number];

export interface Piece {
  readonly seat: Seat;
  readonly position: Vector;
  readonly velocity: Vector;
  /** Charge of the next dash, 0 to 1. */
  charge: number;
  /** Steps since the start; a dash before is not possible. */
  dashReadyAt: number;
  /** The piece is heavier until this step. */
  dashUntil: number;
  power?: { readonly kind: Power; readonly until: number };
  /** Steps with the crown. */
  crownSteps: number;
  /** Number of other pieces it pushed off. */
  pushes: number;
  lastPush?: { readonly by: Seat; readonly at: number };
  /** The step at which it fell. */
  outAt?: number;
}

export interface HillState extends WithRandom {
  /** Steps since the start. */
  step: number;
  readonly pieces: Piece[];
  /** Current radius of the platform, units. */
  radius: number;
  /** The seat that has the crown. */
  crown?: Seat;
  /** The power that lies on the platform, to be picked up. */
  offer?: { readonly kind: Power; readonly position: Vector };
  nextOfferAt: number;
  /** Votes of those who fell, for the next power. */
  votes: Record<Power, number>;
}

/** Units; the radius of a piece is 1. */
export const PLATFORM_RADIUS = 10;
export const MIDDLE_RADIUS = 2;
export const OFFER_RADIUS = 0.6;

export function startHill({ seats, seed }: RoundSetup): HillState {
  return {
    random: randomState(seed),
    step: 0,
    pieces: seats.map((seat, index) => ({
      seat,
      position: onRing(index, seats.length),
      velocity: { x: 0, y: 0 },
      charge: 0,
      dashReadyAt: 0,
      dashUntil: 0,
      crownSteps: 0,
      pushes: 0,
    })),
    radius: PLATFORM_RADIUS,
    nextOfferAt: 8 * 60,
    votes: { spring: 0, anchor: 0, feather: 0 },
  };
}

/** Most that stand side by side in the outer circle; the others stand further in. */
const OUTER = 18;

/** Equal distances round the middle. */
function onRing(index: number, count: number): Vector {
  const isInner = index >= OUTER;
  const turn = isInner ? (index - OUTER) / (count - OUTER) : index / Math.min(count, OUTER);
  const radius = isInner ? 4.7 : count > 12 ? 7.9 : 6.5;
  const { x, y } = onUnitCircle(turn);
  return { x: x * radius, y: y * radius };
}

/** A point on the circle, `turn` from 0 to 1, with quarters that are exact; spaced nearly evenly, without sine. */
export function onUnitCircle(turn: number): Vector {
  const quarters = Math.floor(turn * 4);
  const within = turn * 4 - quarters;
  // Half of the angle's tangent, with a cubic term so that steps of `turn` are steps of the angle to within 0.2 degrees
  const t = within * (0.7854 + within * within * (0.2146 - 0.103 * (1 - within)));
  const cosine = (1 - t * t) / (1 + t * t);
  const sine = (2 * t) / (1 + t * t);
  switch (((quarters % 4) + 4) % 4) {
    case 0:
      return { x: cosine, y: sine };
    case 1:
      return { x: -sine, y: cosine };
    case 2:
      return { x: -cosine, y: -sine };
    default:
      return { x: sine, y: -cosine };
  }
}

/** Those who have not fallen. */
export function standing(state: HillState): Piece[] {
  return state.pieces.filter(({ outAt }) => outAt === undefined);
}

/** A ring of the platform: what lies outside of `inner` falls at `fallsAt`. */
export interface Ring {
  /** Units. */
  readonly inner: number;
  /** Steps since the start. */
  readonly fallsAt: number;
}

/** From the outside in. */
export const RINGS: readonly Ring[] = [
  { inner: 8.5, fallsAt: 25 * STEPS_PER_SECOND },
  { inner: 7, fallsAt: 40 * STEPS_PER_SECOND },
  { inner: 5.5, fallsAt: 52 * STEPS_PER_SECOND },
  { inner: 4, fallsAt: 62 * STEPS_PER_SECOND },
];

/** Sudden death: what is left shrinks without a pause. */
export const SUDDEN_DEATH_AT = 70 * STEPS_PER_SECOND;
const SMALLEST_AT = 95 * STEPS_PER_SECOND;
const SMALLEST = 1.2;
/** Step at which the round ends; pieces still on the platform have survived. */
export const LONGEST = 100 * STEPS_PER_SECOND;

/** The radius of the platform at a step, units. */
export function radiusAt(step: number): number {
  const fallen = RINGS.filter(({ fallsAt }) => step >= fallsAt).at(-1);
  const radius = fallen?.inner ?? PLATFORM_RADIUS;
  if (step < SUDDEN_DEATH_AT) return radius;
  const share = Math.min(1, (step - SUDDEN_DEATH_AT) / (SMALLEST_AT - SUDDEN_DEATH_AT));
  return radius + (SMALLEST - radius) * share;
}

/** The ring that falls next, with the seconds until then; undefined when none does. */
export function nextRing(step: number): { ring: Ring; inS: number } | undefined {
  const ring = RINGS.find(({ fallsAt }) => step < fallsAt);
  return ring && { ring, inS: (ring.fallsAt - step) / STEPS_PER_SECOND };
}
