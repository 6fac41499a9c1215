import { describe, expect, it } from 'vitest';
import { CONTROLLER_GAMEPAD_COMPONENTS, controllerModeOf } from './components.ts';

describe('the controller', () => {
  it('has the components that existing programs rely on', () => {
    expect(CONTROLLER_GAMEPAD_COMPONENTS.map(({ name, format }) => `${name}: ${format}`)).toEqual([
      'orientation: vector3',
      'linear_acceleration: vector3',
      'analog_stick_left: vector2',
      'button_a: keyEvent',
      'button_b: keyEvent',
      'button_start: keyEvent',
      'set_color: color',
      'set_image: image2D',
      'clear_image: bool',
      'vibration_pattern: double',
    ]);
  });

  it('knows its modes by the words that are in use', () => {
    expect(['joycon', 'default', 'Gamepad'].map(controllerModeOf)).toEqual([
      'gamepad',
      'gamepad',
      'gamepad',
    ]);
    expect(controllerModeOf('camera')).toBe('camera');
    expect(controllerModeOf('piano')).toBeUndefined();
  });
});
