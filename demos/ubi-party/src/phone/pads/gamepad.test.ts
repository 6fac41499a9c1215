import { expect, test } from 'vitest';
import { readGamepads, type GamepadReading } from './gamepad.ts';
import { isSteeringKey, steeringOfKeys } from './keys.ts';

function gamepad(axes: readonly number[], down: readonly number[], mapping = 'standard') {
  const buttons = Array.from({ length: 17 }, (_, at) => ({ pressed: down.includes(at) }));
  return { connected: true, mapping, axes, buttons } satisfies GamepadReading;
}

test('left stick of a gamepad steers, away from the player is positive', () => {
  expect(readGamepads([gamepad([1, 0], [])]).steering).toEqual({ x: 1, y: 0 });
  expect(readGamepads([gamepad([0, -1], [])]).steering).toEqual({ x: 0, y: 1 });
  expect(readGamepads([gamepad([0.05, 0.05], [])]).steering).toEqual({ x: 0, y: 0 });
});

test('cross of a gamepad steers, and wins over the stick', () => {
  expect(readGamepads([gamepad([1, 0], [14])]).steering).toEqual({ x: -1, y: 0 });
});

test('large buttons and triggers press, start and the cross do not', () => {
  const presses = [0, 1, 7, 9, 12].filter((at) => readGamepads([gamepad([0, 0], [at])]).isPressed);
  expect(presses).toEqual([0, 1, 7]);
});

test('gamepads without the standard mapping, and empty places, are passed over', () => {
  const odd = gamepad([1, 1], [0], '');
  expect(readGamepads([null, odd])).toEqual({ steering: { x: 0, y: 0 }, isPressed: false });
  expect(readGamepads([null, odd, gamepad([1, 0], [])]).steering.x).toBe(1);
});

test('arrows and WASD steer, opposite keys cancel out, diagonals are no longer', () => {
  expect(steeringOfKeys(new Set(['KeyW']))).toEqual({ x: 0, y: 1 });
  expect(steeringOfKeys(new Set(['ArrowLeft', 'KeyD']))).toEqual({ x: 0, y: 0 });
  const { x, y } = steeringOfKeys(new Set(['ArrowRight', 'ArrowDown']));
  expect(Math.hypot(x, y)).toBeCloseTo(1);
  expect([isSteeringKey('KeyS'), isSteeringKey('KeyQ')]).toEqual([true, false]);
});
