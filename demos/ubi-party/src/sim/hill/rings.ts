import { STEPS_PER_SECOND } from '../game.ts';
import { PLATFORM_RADIUS } from './hill-state.ts';

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
