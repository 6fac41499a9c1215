import type { ComponentInit } from '@ubii/client-web';
import { canVibrate } from '../outputs/vibrate.ts';

/** Name that existing programs look for. */
export const CONTROLLER_DEVICE = 'web-interface-ubii-controller';
export const CONTROLLER_GAMEPAD_DEVICE = 'web-interface-ubii-controller-gamepad';

/** Component that switches between gamepad and camera; its topic is `/<client id>/<device>/set_controllerMode`. */
export const CONTROLLER_COMPONENTS = [
  {
    name: 'set_controllerMode',
    format: 'string',
    ioType: 'subscriber',
    description: '`gamepad` (or `joycon`, `default`) or `camera`.',
  },
] as const satisfies readonly ComponentInit[];

/** Topics are `/<client id>/web-interface-ubii-controller-gamepad/<name>`, as existing programs expect. */
export const CONTROLLER_GAMEPAD_COMPONENTS = [
  {
    name: 'orientation',
    format: 'vector3',
    tags: ['imu', 'orientation'],
    description: 'Degrees about z, x and y (alpha, beta, gamma), relative to the calibration.',
  },
  {
    name: 'linear_acceleration',
    format: 'vector3',
    tags: ['acceleration', 'linear'],
    description: 'Acceleration without gravity, m/s², in the axes of the device.',
  },
  {
    name: 'analog_stick_left',
    format: 'vector2',
    tags: ['stick'],
    description: 'x to the right, y upwards, −1 to 1; the length is at most 1.',
  },
  { name: 'button_a', format: 'keyEvent', tags: ['button'], description: 'Key "1".' },
  { name: 'button_b', format: 'keyEvent', tags: ['button'], description: 'Key "2".' },
  { name: 'button_start', format: 'keyEvent', tags: ['button'], description: 'Key "start".' },
  {
    name: 'set_color',
    format: 'color',
    ioType: 'subscriber',
    tags: ['color'],
    description: 'Fills the screen of the controller; an alpha of 0 removes the colour.',
  },
  {
    name: 'set_image',
    format: 'image2D',
    ioType: 'subscriber',
    tags: ['image'],
    description: 'A picture on the screen of the controller.',
  },
  {
    name: 'clear_image',
    format: 'bool',
    ioType: 'subscriber',
    tags: ['image'],
    description: 'Any value removes the picture.',
  },
  {
    name: 'vibration_pattern',
    format: 'double',
    ioType: 'subscriber',
    tags: ['vibration'],
    description: 'Vibration time, milliseconds; only on devices that can vibrate.',
  },
] as const satisfies readonly ComponentInit[];

type Components = typeof CONTROLLER_GAMEPAD_COMPONENTS;

/** Components of this device; without the one for vibration if it cannot vibrate. */
export function controllerGamepadComponents(): Components {
  if (canVibrate()) return CONTROLLER_GAMEPAD_COMPONENTS;
  return CONTROLLER_GAMEPAD_COMPONENTS.filter(
    ({ name }) => name !== 'vibration_pattern',
  ) as unknown as Components;
}

export type ControllerMode = 'gamepad' | 'camera';

/** Parses a requested mode; `undefined` for unknown ones. */
export function controllerModeOf(text: string): ControllerMode | undefined {
  switch (text.trim().toLowerCase()) {
    case 'gamepad':
    case 'joycon':
    case 'default':
      return 'gamepad';
    case 'camera':
      return 'camera';
    default:
      return undefined;
  }
}
