import { describe, expect, it } from 'vitest';
import { Shake } from './shake.ts';

/** @returns whether one of the moves completes a shake */
function shakes(xs: readonly number[], stepMs: number): boolean {
  const shake = new Shake();
  return xs.map((x, index) => shake.add(x, index * stepMs)).some(Boolean);
}

describe('Shake', () => {
  it('notices quick turns', () => {
    expect(shakes([0, 20, 40, 5, 0, 40, 0, 40, 0], 20)).toBe(true);
  });

  it('takes a drag for a drag, also there and back', () => {
    expect(shakes([0, 50, 100, 200, 100, 50, 60, 80], 20)).toBe(false);
  });

  it('takes slow turns and small ones for aiming', () => {
    expect(shakes([0, 40, 0, 40, 0, 40, 0, 40], 400)).toBe(false);
    expect(shakes([0, 10, 0, 10, 0, 10, 0, 10, 0], 20)).toBe(false);
  });
});
