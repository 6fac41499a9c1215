import { directionOf } from './gamepad.ts';
import type { Steering } from './stick.ts';

/** By `KeyboardEvent.code`: the place of the key counts, not its letter. */
const DIRECTIONS = {
  left: ['ArrowLeft', 'KeyA'],
  right: ['ArrowRight', 'KeyD'],
  down: ['ArrowDown', 'KeyS'],
  up: ['ArrowUp', 'KeyW'],
} as const;
const STEERING_KEYS: ReadonlySet<string> = new Set(Object.values(DIRECTIONS).flat());

export function isSteeringKey(code: string): boolean {
  return STEERING_KEYS.has(code);
}

export function isPressKey(code: string): boolean {
  return code === 'Space';
}

/** @param held codes of the keys that are down */
export function steeringOfKeys(held: ReadonlySet<string>): Steering {
  const isHeld = (codes: readonly string[]): boolean => codes.some((code) => held.has(code));
  const { left, right, down, up } = DIRECTIONS;
  return directionOf(isHeld(left), isHeld(right), isHeld(down), isHeld(up));
}
