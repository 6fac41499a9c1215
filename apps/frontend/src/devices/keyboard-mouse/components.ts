import type { ComponentInit } from '@ubii/client-web';

export const KEYBOARD_MOUSE_DEVICE = 'web-interface-keyboard-mouse';

/** The same names as for phones and controllers where the meaning is the same, so that each can replace the other. */
export const KEYBOARD_MOUSE_COMPONENTS = [
  {
    name: 'button',
    format: 'keyEvent',
    tags: ['button', 'keyboard'],
    description: 'Keys, pressed and released, by the text they type: "a", "Enter", "ArrowUp".',
  },
  {
    name: 'analog_stick_left',
    format: 'vector2',
    tags: ['stick', 'keyboard'],
    description: 'W, A, S, D or the arrow keys as a stick: x to the right, y upwards, −1 to 1.',
  },
  {
    name: 'touch_position',
    format: 'vector2',
    tags: ['touch', 'pointer', 'mouse'],
    description: 'The mouse on the pad, 0 to 1 on both axes, origin top left.',
  },
  {
    name: 'mouse_button',
    format: 'mouseEvent',
    tags: ['button', 'mouse'],
    description: 'Buttons of the mouse, pressed and released: 0 main, 1 wheel, 2 secondary.',
  },
  {
    name: 'mouse_wheel',
    format: 'vector2',
    tags: ['mouse'],
    description: 'Wheel movement, pixels to the right and down.',
  },
  {
    name: 'mouse_movement',
    format: 'vector2',
    tags: ['mouse'],
    description:
      'Mouse movement, pixels to the right and down, while the pad has captured the mouse.',
  },
] as const satisfies readonly ComponentInit[];
