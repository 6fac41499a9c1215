import { expect, it } from 'vitest';
import { about, fromAngles, rotate, toAngles, turned } from './rotation.ts';

it('angles and rotations say the same', () => {
  for (const angles of [
    { yaw: 30, pitch: 20, roll: -50 },
    { yaw: -170, pitch: -80, roll: 10 },
    { yaw: 0, pitch: 0, roll: 0 },
  ]) {
    const { yaw, pitch, roll } = toAngles(fromAngles(angles));
    expect(yaw).toBeCloseTo(angles.yaw, 2);
    expect(pitch).toBeCloseTo(angles.pitch, 2);
    expect(roll).toBeCloseTo(angles.roll, 2);
  }
});

it('turns points as the right hand does', () => {
  const [x, y, z] = rotate(about('z', 90), [1, 0, 0]);
  expect([x, y, z].map((part) => Math.round(part))).toEqual([0, 1, 0]);
  const both = rotate(turned(about('z', 90), about('x', 90)), [1, 0, 0]);
  expect(both.map((part) => Math.round(part))).toEqual([0, 0, 1]);
});
