import type { Controller } from '../../sim/index.ts';
import { stickAt, STRAIGHT, steered, type Steering } from './stick.ts';

/** The part of `Gamepad` that is read. */
export interface GamepadReading {
  readonly connected: boolean;
  readonly mapping: string;
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean }[];
}

interface GamepadInput {
  readonly steering: Steering;
  readonly isPressed: boolean;
}

/** Standard mapping, https://w3c.github.io/gamepad/#remapping: the four on the right and both triggers. */
const PRESSES = [0, 1, 2, 3, 6, 7];
const [UP, DOWN, LEFT, RIGHT] = [12, 13, 14, 15];

/** Left stick or cross, and any large button, of the first gamepad with the standard mapping. */
export function readGamepads(gamepads: readonly (GamepadReading | null)[]): GamepadInput {
  const pad = gamepads.find((one) => one?.connected && one.mapping === 'standard');
  if (!pad) return { steering: STRAIGHT, isPressed: false };
  const isDown = (button: number): boolean => pad.buttons[button]?.pressed === true;
  const cross = directionOf(isDown(LEFT), isDown(RIGHT), isDown(DOWN), isDown(UP));
  const stick = stickAt({ x: 0, y: 0 }, { x: pad.axes[0] ?? 0, y: pad.axes[1] ?? 0 }, 1);
  return {
    steering: cross.x !== 0 || cross.y !== 0 ? cross : stick,
    isPressed: PRESSES.some(isDown),
  };
}

/** Of keys or a cross; no further than 1 across. */
function directionOf(isLeft: boolean, isRight: boolean, isDown: boolean, isUp: boolean): Steering {
  const x = Number(isRight) - Number(isLeft);
  const y = Number(isUp) - Number(isDown);
  return x !== 0 && y !== 0 ? { x: x * Math.SQRT1_2, y: y * Math.SQRT1_2 } : { x, y };
}

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

/** Time of the sweep: from left to right and back, or once round. Slow enough to aim, milliseconds. */
const SWEEP_MS = 3600;
/** Near the middle of a wheel is straight ahead, so that one can aim at it. */
const STRAIGHT_SHARE = 0.14;

/**
 * Steering with one button: a pointer sweeps by itself, a press takes its direction, which is kept until the next
 * press. While the button is held the pointer waits, so that a dash that charges flies where it was aimed.
 */
interface OneButton {
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

/** Degrees of tilt for a full deflection: the wrists reach it without letting go. */
const FULL_TILT = 32;
const DEAD_ZONE = 0.06;
const RADIANS = Math.PI / 180;

/**
 * Angle by which the right edge of the shown page is below its left edge, degrees, -90 to 90. The same for a phone that
 * lies flat and one that is held upright like a steering wheel.
 *
 * @param beta @param gamma of `deviceorientation`, degrees
 * @param screenAngle `screen.orientation.angle`, degrees
 */
export function tiltOf(beta: number, gamma: number, screenAngle: number): number {
  // Down in the axes of the device, https://www.w3.org/TR/orientation-event/ (Z-X'-Y''), then turned to the screen
  const downX = Math.cos(beta * RADIANS) * Math.sin(gamma * RADIANS);
  const downY = -Math.sin(beta * RADIANS);
  const angle = screenAngle * RADIANS;
  const onScreen = downX * Math.cos(angle) - downY * Math.sin(angle);
  return Math.asin(Math.min(1, Math.max(-1, onScreen))) / RADIANS;
}

/** @param neutral the tilt that drives straight ahead, set by Re-centre, degrees */
export function steeringOfTilt(tilt: number, neutral: number): number {
  return steered((tilt - neutral) / FULL_TILT, DEAD_ZONE);
}
