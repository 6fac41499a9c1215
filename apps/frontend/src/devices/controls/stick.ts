import type { Vector2 } from '@ubii/proto';

/** Limits a position to the unit circle. Sticks use x to the right and y upwards, both −1 to 1. */
export function withinCircle({ x, y }: Vector2): Vector2 {
  const length = Math.hypot(x, y);
  return length > 1 ? { x: x / length, y: y / length } : { x, y };
}

/**
 * Applies a dead zone, because gamepad sticks do not rest exactly in the centre: 0 inside; outside, values start at 0
 * and still reach 1.
 *
 * @param deadZone 0 to less than 1
 */
export function withDeadZone(at: Vector2, deadZone: number): Vector2 {
  const { x, y } = withinCircle(at);
  const length = Math.hypot(x, y);
  if (length <= deadZone) return { x: 0, y: 0 };
  const scale = (length - deadZone) / (1 - deadZone) / length;
  return { x: x * scale, y: y * scale };
}

const DIRECTIONS: Readonly<Record<string, Vector2>> = {
  ArrowUp: { x: 0, y: 1 },
  ArrowDown: { x: 0, y: -1 },
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  KeyW: { x: 0, y: 1 },
  KeyS: { x: 0, y: -1 },
  KeyA: { x: -1, y: 0 },
  KeyD: { x: 1, y: 0 },
};

/** Whether a key moves a stick, by `event.code`. */
export const isStickKey = (code: string): boolean => code in DIRECTIONS;

/** Returns the stick position for pressed arrow keys or W, A, S and D. */
export function stickOfKeys(codes: Iterable<string>): Vector2 {
  let x = 0;
  let y = 0;
  for (const code of codes) {
    x += DIRECTIONS[code]?.x ?? 0;
    y += DIRECTIONS[code]?.y ?? 0;
  }
  return withinCircle({ x: Math.sign(x), y: Math.sign(y) });
}
