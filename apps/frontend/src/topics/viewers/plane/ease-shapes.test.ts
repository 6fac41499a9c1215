import { expect, it } from 'vitest';
import { FOLLOW_MS, ShapeEasing, VANISH_MS } from './ease-shapes.ts';
import type { PlaneShape } from './plane-shapes.ts';

const at = (x: number, key = 'a'): PlaneShape => ({
  key,
  name: 'cup',
  x,
  y: 0,
  size: { width: x, height: 1 },
});

it('draws a new shape at once, and moves it to its next place within 80 ms', () => {
  const easing = new ShapeEasing();
  easing.set([at(0)], 0);
  expect(easing.at(0)).toEqual({ shapes: [at(0)], isMoving: false });
  easing.set([at(1)], 1000);
  expect(easing.at(1000).shapes[0]!.x).toBe(0);
  const half = easing.at(1000 + FOLLOW_MS / 2);
  expect(half.isMoving).toBe(true);
  expect(half.shapes[0]!.x).toBeCloseTo(0.75);
  expect(half.shapes[0]!.size!.width).toBeCloseTo(0.75);
  expect(easing.at(1000 + FOLLOW_MS)).toEqual({ shapes: [at(1)], isMoving: false });
});

it('goes on from where it is drawn when the next place comes early', () => {
  const easing = new ShapeEasing();
  easing.set([at(0)], 0);
  easing.set([at(1)], 1000);
  easing.set([at(0)], 1000 + FOLLOW_MS / 2);
  expect(easing.at(1000 + FOLLOW_MS / 2).shapes[0]!.x).toBeCloseTo(0.75);
});

it('lets a shape vanish in 160 ms where it was, and draws it at once when it comes back', () => {
  const easing = new ShapeEasing();
  easing.set([at(0.3)], 0);
  easing.set([], 1000);
  const half = easing.at(1000 + VANISH_MS / 2);
  expect(half.shapes).toEqual([{ ...at(0.3), opacity: 0.5 }]);
  expect(half.isMoving).toBe(true);
  easing.set([at(0.9)], 1100);
  expect(easing.at(1100).shapes).toEqual([at(0.9)]);
  easing.set([], 2000);
  expect(easing.at(2000 + VANISH_MS)).toEqual({ shapes: [], isMoving: true });
  expect(easing.at(2000 + VANISH_MS + 16)).toEqual({ shapes: [], isMoving: false });
});
