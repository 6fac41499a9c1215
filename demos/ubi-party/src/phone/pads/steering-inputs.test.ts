import { expect, test } from 'vitest';

import {
  readGamepads,
  isSteeringKey,
  steeringOfKeys,
  ONE_BUTTON_AT_REST,
  pressed,
  sweepOf,
  swept,
  steeringOfTilt,
  tiltOf,
  type GamepadReading,
} from './steering-inputs.ts';

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

const after = (ms: number) => swept(ONE_BUTTON_AT_REST, ms);

test('pointer of a wheel sweeps right, then left, and waits in the middle', () => {
  expect(sweepOf(after(900), 'wheel').x).toBe(1);
  expect(sweepOf(after(2700), 'wheel').x).toBe(-1);
  expect(sweepOf(after(1750), 'wheel').x).toBe(0);
  expect(sweepOf(after(3600), 'wheel').x).toBe(0);
});

test('pointer of a stick goes round, away from the player first', () => {
  expect(sweepOf(after(0), 'stick')).toEqual({ x: 0, y: 1 });
  expect(sweepOf(after(900), 'stick').x).toBeCloseTo(1);
  expect(sweepOf(after(1800), 'stick').y).toBeCloseTo(-1);
});

test('press takes the direction and keeps it while the pointer goes on', () => {
  const down = pressed(after(900), true, 'wheel');
  expect(down.taken).toEqual({ x: 1, y: 0 });
  const later = swept(pressed(down, false, 'wheel'), 1800);
  expect(later.taken).toEqual({ x: 1, y: 0 });
  expect(sweepOf(later, 'wheel').x).toBe(-1);
});

test('pointer waits while the button is held, so that a dash flies where it was aimed', () => {
  const down = pressed(after(900), true, 'stick');
  expect(swept(down, 500)).toEqual(down);
});

test('nothing is steered before the first press, nor in a game without steering', () => {
  expect(after(900).taken).toEqual({ x: 0, y: 0 });
  expect(pressed(after(900), true, 'none').taken).toEqual({ x: 0, y: 0 });
});

test('tilt of a flat phone is how far its right edge is down', () => {
  expect(tiltOf(0, 20, 0)).toBeCloseTo(20);
  expect(tiltOf(0, -20, 0)).toBeCloseTo(-20);
});

test('tilt of a phone in landscape follows the long side', () => {
  // Turned to the left, the top of the device is the left edge of what is shown.
  expect(tiltOf(0, -90, 90)).toBeCloseTo(0);
  expect(tiltOf(-20, -70, 90)).toBeLessThan(0);
  expect(tiltOf(20, -70, 90)).toBeCloseTo(-tiltOf(-20, -70, 90));
  // Turned to the right, it is the other way round.
  expect(tiltOf(20, 70, 270)).toBeCloseTo(-tiltOf(20, -70, 90));
});

test('tilt of a phone that is held upright like a wheel is the turn of the wheel', () => {
  // Upright and turned by 30 degrees clockwise: down is 30 degrees off the lower edge.
  const turned = (30 * Math.PI) / 180;
  const beta = (Math.asin(Math.cos(turned)) * 180) / Math.PI;
  expect(tiltOf(beta, 90, 0)).toBeCloseTo(30);
  expect(tiltOf(90, 0, 0)).toBeCloseTo(0);
});

test('tilt is the same however far the phone leans towards its player', () => {
  for (const beta of [0, 30, 60]) {
    const gamma = (Math.asin(0.3 / Math.cos((beta * Math.PI) / 180)) * 180) / Math.PI;
    expect(tiltOf(beta, gamma, 0)).toBeCloseTo((Math.asin(0.3) * 180) / Math.PI);
  }
});

test('steering is 0 at the neutral tilt and full 32 degrees from it', () => {
  expect(steeringOfTilt(7, 7)).toBe(0);
  expect(steeringOfTilt(39, 7)).toBe(1);
  expect(steeringOfTilt(-60, 7)).toBe(-1);
});
