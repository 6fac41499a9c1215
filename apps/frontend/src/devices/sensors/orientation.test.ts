import { describe, expect, it } from 'vitest';
import { calibratedAngles, quaternionOf, turnSince } from './orientation.ts';

const HALF = Math.SQRT1_2;
const flat = { alpha: 0, beta: 0, gamma: 0 };

function expectTurn(actual: object, expected: object): void {
  for (const [axis, value] of Object.entries(expected)) {
    expect(actual[axis as keyof typeof actual], axis).toBeCloseTo(value as number, 10);
  }
}

describe('the orientation of a device', () => {
  it('is no turn when it lies flat, its top to the north', () => {
    expectTurn(quaternionOf(flat), { x: 0, y: 0, z: 0, w: 1 });
  });

  it.each([
    ['alpha', { ...flat, alpha: 90 }, { x: 0, y: 0, z: HALF, w: HALF }],
    ['beta', { ...flat, beta: 90 }, { x: HALF, y: 0, z: 0, w: HALF }],
    ['gamma', { ...flat, gamma: 90 }, { x: 0, y: HALF, z: 0, w: HALF }],
  ])('turns about the axis of %s', (_name, angles, turn) => {
    expectTurn(quaternionOf(angles), turn);
  });

  it('turns about z first, then about the turned x [W3C orientation-event, Z-X′-Y″]', () => {
    // Flat with its top to the west, then rotated about its own x: its top points up.
    const { x, y, z, w } = quaternionOf({ alpha: 90, beta: 90, gamma: 0 });
    // The device's y axis (0, 1, 0), rotated.
    const top = { x: 2 * (x * y - w * z), y: 1 - 2 * (x * x + z * z), z: 2 * (y * z + w * x) };
    expectTurn(top, { x: 0, y: 0, z: 1 });
  });

  it('has the length 1 whatever the angles', () => {
    const { x, y, z, w } = quaternionOf({ alpha: 283.4, beta: -171, gamma: 61 });
    expect(Math.hypot(x, y, z, w)).toBeCloseTo(1, 12);
  });

  it('is no turn since itself', () => {
    const now = quaternionOf({ alpha: 283.4, beta: -17, gamma: 61 });
    expectTurn(turnSince(now, now), { x: 0, y: 0, z: 0, w: 1 });
  });

  it('is seen from where it lay at the calibration', () => {
    const west = quaternionOf({ ...flat, alpha: 90 });
    const raised = quaternionOf({ alpha: 90, beta: 90, gamma: 0 });
    expectTurn(turnSince(west, raised), { x: HALF, y: 0, z: 0, w: HALF });
  });

  it('is less the calibration in each axis, the shorter way round', () => {
    expect(calibratedAngles({ alpha: 10, beta: 5, gamma: -3 }, undefined)).toEqual({
      x: 10,
      y: 5,
      z: -3,
    });
    expect(
      calibratedAngles({ alpha: 10, beta: -170, gamma: -3 }, { alpha: 350, beta: 170, gamma: 7 }),
    ).toEqual({ x: 20, y: 20, z: -10 });
  });
});
