import type { Controller } from '../../sim/index.ts';
import { STRAIGHT, type Steering } from './stick.ts';

/** Time of the sweep: from left to right and back, or once round. Slow enough to aim, milliseconds. */
const SWEEP_MS = 3600;
/** Near the middle of a wheel is straight ahead, so that one can aim at it. */
const STRAIGHT_SHARE = 0.14;

/**
 * Steering with one button: a pointer sweeps by itself, a press takes its direction, which is kept until the next
 * press. While the button is held the pointer waits, so that a dash that charges flies where it was aimed.
 */
export interface OneButton {
  /** Elapsed time of the sweep, without holds, milliseconds. */
  readonly sweptMs: number;
  readonly isHeld: boolean;
  /** The current steering. */
  readonly taken: Steering;
}

export const ONE_BUTTON_AT_REST: OneButton = { sweptMs: 0, isHeld: false, taken: STRAIGHT };

type Kind = Controller['steering'];

/** Direction of the sweeping pointer. */
export function sweepOf({ sweptMs }: OneButton, kind: Kind): Steering {
  const share = (sweptMs % SWEEP_MS) / SWEEP_MS;
  if (kind === 'none') return STRAIGHT;
  if (kind === 'stick')
    return { x: Math.sin(share * 2 * Math.PI), y: Math.cos(share * 2 * Math.PI) };
  // From the middle to the right, to the left, and back
  const quarters = share * 4;
  const x = quarters <= 1 ? quarters : quarters <= 3 ? 2 - quarters : quarters - 4;
  return { x: Math.abs(x) < STRAIGHT_SHARE ? 0 : x, y: 0 };
}

export function swept(state: OneButton, passedMs: number): OneButton {
  return state.isHeld ? state : { ...state, sweptMs: state.sweptMs + passedMs };
}

export function pressed(state: OneButton, isDown: boolean, kind: Kind): OneButton {
  if (!isDown || state.isHeld) return { ...state, isHeld: isDown };
  return { ...state, isHeld: true, taken: sweepOf(state, kind) };
}
