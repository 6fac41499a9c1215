import type { Vector2 } from '@ubii/proto';
import { withDeadZone } from '../controls/stick.ts';
import { PAD_BUTTONS, type PadButton } from './components.ts';

/** Dead zone of sticks, as a share of their range. */
export const DEAD_ZONE = 0.12;

/** The part of `Gamepad` that is used. */
export interface PadSource {
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean; readonly value: number }[];
}

/** State of a pad. */
export interface PadState {
  readonly left: Vector2;
  readonly right: Vector2;
  readonly leftTrigger: number;
  readonly rightTrigger: number;
  readonly down: ReadonlySet<PadButton>;
}

const MIDDLE: Vector2 = { x: 0, y: 0 };
/** State of an untouched pad. */
export const RESTING: PadState = {
  left: MIDDLE,
  right: MIDDLE,
  leftTrigger: 0,
  rightTrigger: 0,
  down: new Set(),
};

/** Reads a pad of the standard mapping; missing controls are at rest. Browsers count y downwards. */
export function readPad({ axes, buttons }: PadSource, deadZone: number = DEAD_ZONE): PadState {
  // Avoid −0, which would be a different value than 0.
  const stick = (x: number): Vector2 =>
    withDeadZone({ x: axes[x] ?? 0, y: 0 - (axes[x + 1] ?? 0) }, deadZone);
  return {
    left: stick(0),
    right: stick(2),
    leftTrigger: buttons[6]?.value ?? 0,
    rightTrigger: buttons[7]?.value ?? 0,
    down: new Set(
      PAD_BUTTONS.filter(({ index }) => buttons[index]?.pressed).map(({ name }) => name),
    ),
  };
}

/** Returns the events for a change of a pad's state. */
export function padChanges(before: PadState, after: PadState) {
  const stick = (name: 'left' | 'right') =>
    before[name].x !== after[name].x || before[name].y !== after[name].y ? after[name] : undefined;
  const trigger = (name: 'leftTrigger' | 'rightTrigger') =>
    before[name] === after[name] ? undefined : after[name];
  return {
    left: stick('left'),
    right: stick('right'),
    leftTrigger: trigger('leftTrigger'),
    rightTrigger: trigger('rightTrigger'),
    buttons: PAD_BUTTONS.flatMap(({ name, key }) =>
      before.down.has(name) === after.down.has(name)
        ? []
        : { name, key, isDown: after.down.has(name) },
    ),
  };
}
