import { describe, expect, it } from 'vitest';
import { quaternionOf } from '../../devices/sensors/orientation.ts';
import { degreesOf, modelTurn, STRAIGHT, turnAbout, turnBy, unitTurn } from './turns.ts';

const close = (a: object, b: object) => {
  for (const [part, value] of Object.entries(b)) {
    expect(a[part as keyof typeof a]).toBeCloseTo(value as number, 6);
  }
};

describe('turns of the model', () => {
  it('are composed, and have an angle', () => {
    const quarter = turnAbout([0, 0, 1], Math.PI / 2);
    close(turnBy(quarter, quarter), turnAbout([0, 0, 1], Math.PI));
    expect(degreesOf(quarter)).toBeCloseTo(90);
    expect(degreesOf(STRAIGHT)).toBe(0);
    // q and -q are the same rotation.
    expect(degreesOf({ x: 0, y: 0, z: 0, w: -1 })).toBe(0);
  });

  it('a quaternion that is not a rotation is ignored', () => {
    expect(unitTurn({ x: 0, y: 0, z: 0, w: 0 })).toBeUndefined();
    expect(unitTurn({ x: NaN, y: 0, z: 0, w: 1 })).toBeUndefined();
    expect(unitTurn({ x: 0, y: 0, z: 0, w: 2 })).toEqual(STRAIGHT);
  });

  it('the model is flat for a flat phone, and upright for an upright phone', () => {
    close(modelTurn(STRAIGHT, undefined), turnAbout([1, 0, 0], -Math.PI / 2));
    close(modelTurn(quaternionOf({ alpha: 0, beta: 90, gamma: 0 }), undefined), STRAIGHT);
  });

  it('with a zero, the model has the rotation since then', () => {
    const held = quaternionOf({ alpha: 123, beta: 40, gamma: -12 });
    close(modelTurn(held, held), STRAIGHT);
    const tilted = turnBy(held, turnAbout([1, 0, 0], 0.3));
    close(modelTurn(tilted, held), turnAbout([1, 0, 0], 0.3));
  });
});
