import { stickAt, STRAIGHT, type Steering } from './stick.ts';

/** The part of `Gamepad` that is read. */
export interface GamepadReading {
  readonly connected: boolean;
  readonly mapping: string;
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean }[];
}

export interface GamepadInput {
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
export function directionOf(
  isLeft: boolean,
  isRight: boolean,
  isDown: boolean,
  isUp: boolean,
): Steering {
  const x = Number(isRight) - Number(isLeft);
  const y = Number(isUp) - Number(isDown);
  return x !== 0 && y !== 0 ? { x: x * Math.SQRT1_2, y: y * Math.SQRT1_2 } : { x, y };
}
