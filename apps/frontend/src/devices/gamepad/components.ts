import type { ComponentInit } from '@ubii/client-web';

/** Name of the first pad's device; others have their number appended: `web-interface-gamepad-2`. */
export const GAMEPAD_DEVICE = 'web-interface-gamepad';

/** Buttons by index in the standard mapping. A, B and Start have the keys of the phone controller. */
export const PAD_BUTTONS = [
  { name: 'button_a', index: 0, key: '1', text: 'A' },
  { name: 'button_b', index: 1, key: '2', text: 'B' },
  { name: 'button_x', index: 2, key: 'x', text: 'X' },
  { name: 'button_y', index: 3, key: 'y', text: 'Y' },
  { name: 'button_shoulder_left', index: 4, key: 'shoulder_left', text: 'L1' },
  { name: 'button_shoulder_right', index: 5, key: 'shoulder_right', text: 'R1' },
  { name: 'button_select', index: 8, key: 'select', text: 'Select' },
  { name: 'button_start', index: 9, key: 'start', text: 'Start' },
  { name: 'button_stick_left', index: 10, key: 'stick_left', text: 'L3' },
  { name: 'button_stick_right', index: 11, key: 'stick_right', text: 'R3' },
  { name: 'button_up', index: 12, key: 'up', text: 'Up' },
  { name: 'button_down', index: 13, key: 'down', text: 'Down' },
  { name: 'button_left', index: 14, key: 'left', text: 'Left' },
  { name: 'button_right', index: 15, key: 'right', text: 'Right' },
] as const;

export type PadButton = (typeof PAD_BUTTONS)[number]['name'];

const button = <N extends PadButton>(name: N) =>
  ({
    name,
    format: 'keyEvent',
    tags: ['button'],
    description: 'Button events: pressed and released.',
  }) as const;

/** The same names as for the phone controller, so that each can replace the other. */
export const GAMEPAD_COMPONENTS = [
  {
    name: 'analog_stick_left',
    format: 'vector2',
    tags: ['stick'],
    description: 'x to the right, y upwards, −1 to 1; the length is at most 1.',
  },
  {
    name: 'analog_stick_right',
    format: 'vector2',
    tags: ['stick'],
    description: 'x to the right, y upwards, −1 to 1; the length is at most 1.',
  },
  { name: 'trigger_left', format: 'double', tags: ['trigger'], description: '0 to 1.' },
  { name: 'trigger_right', format: 'double', tags: ['trigger'], description: '0 to 1.' },
  button('button_a'),
  button('button_b'),
  button('button_x'),
  button('button_y'),
  button('button_shoulder_left'),
  button('button_shoulder_right'),
  button('button_select'),
  button('button_start'),
  button('button_stick_left'),
  button('button_stick_right'),
  button('button_up'),
  button('button_down'),
  button('button_left'),
  button('button_right'),
  {
    name: 'vibration_pattern',
    format: 'double',
    ioType: 'subscriber',
    tags: ['vibration'],
    description: 'Rumble time, milliseconds.',
  },
] as const satisfies readonly ComponentInit[];
