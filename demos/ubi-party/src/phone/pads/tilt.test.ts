import { expect, test } from 'vitest';
import { steeringOfTilt, tiltOf } from './tilt.ts';

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
