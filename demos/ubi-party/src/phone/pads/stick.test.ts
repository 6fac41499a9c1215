import fc from 'fast-check';
import { expect, test } from 'vitest';
import { inside, leashed, stickAt, steered, STRAIGHT, wheelAt } from './stick.ts';

const ORIGIN = { x: 100, y: 500 };

test('stick goes right and away from the player with the thumb', () => {
  const { x, y } = stickAt(ORIGIN, { x: 172, y: 500 }, 72);
  expect([x, y]).toEqual([1, 0]);
  expect(stickAt(ORIGIN, { x: 100, y: 428 }, 72).y).toBe(1);
  expect(stickAt(ORIGIN, { x: 100, y: 572 }, 72).y).toBe(-1);
});

test('stick stays straight inside the dead zone and begins with 0 at its edge', () => {
  expect(stickAt(ORIGIN, { x: 104, y: 503 }, 72)).toBe(STRAIGHT);
  const { x } = stickAt(ORIGIN, { x: 109, y: 500 }, 72);
  expect(x).toBeGreaterThan(0);
  expect(x).toBeLessThan(0.02);
});

test('stick is never longer than 1 and keeps the direction of the thumb', () => {
  const pixels = fc.integer({ min: -900, max: 900 });
  fc.assert(
    fc.property(pixels, pixels, (dx, dy) => {
      const { x, y } = stickAt(ORIGIN, { x: ORIGIN.x + dx, y: ORIGIN.y + dy }, 72);
      expect(Math.hypot(x, y)).toBeLessThanOrEqual(1 + 1e-9);
      expect(x * -dy - y * dx).toBeCloseTo(0, 6);
    }),
  );
});

test('wheel under a thumb moves sideways only', () => {
  expect(wheelAt(ORIGIN, { x: -900, y: 0 }, 100)).toEqual({ x: -1, y: 0 });
  expect(wheelAt(ORIGIN, { x: 100, y: 0 }, 100)).toEqual({ x: 0, y: 0 });
});

test('origin follows a thumb that goes too far, so that turning back answers at once', () => {
  expect(leashed(ORIGIN, { x: 150, y: 500 }, 72)).toBe(ORIGIN);
  const origin = leashed(ORIGIN, { x: 400, y: 500 }, 72);
  expect(origin).toEqual({ x: 310, y: 500 });
  expect(stickAt(origin, { x: 300, y: 500 }, 72).x).toBeLessThan(0);
});

test('axis clamps and has its dead zone on both sides', () => {
  expect([steered(-3, 0.1), steered(-0.1, 0.1)]).toEqual([-1, 0]);
  expect(steered(0.55, 0.1)).toBeCloseTo(0.5);
});

test('plate stays on its pad, however far the thumb goes', () => {
  const box = { x: 0, y: 500, width: 220, height: 100 };
  expect(inside(box, { x: 100, y: 540 }, 40)).toEqual({ x: 100, y: 540 });
  expect(inside(box, { x: 400, y: 20 }, 40)).toEqual({ x: 180, y: 540 });
  expect(inside(box, { x: 400, y: 20 }, 80)).toEqual({ x: 140, y: 550 });
});
