import { expect, it } from 'vitest';
import { Framing } from './framing.ts';
import type { Point, SpaceThing } from './space-things.ts';

const thing = (at: Point): SpaceThing => ({
  key: String(at),
  name: '',
  at,
  mark: 'axes',
  isToScale: false,
});
const MARKERS = [thing([-0.1, 0, 0.8]), thing([0.2, 0.1, 0.9])];
const WHOLE = { center: [0, 0, 0], radius: 1 };

it('shows the whole ground of one thing', () => {
  expect(new Framing().around([thing([0, 0, 0.5])], 1)).toEqual(WHOLE);
});

it('shows several things and the origin as large as they can be', () => {
  const { center, radius } = new Framing().around(MARKERS, 1);
  expect(center[2]).toBeCloseTo(0.45);
  expect(radius).toBeLessThan(0.6);
  for (const { at } of [...MARKERS, thing([0, 0, 0])]) {
    expect(Math.hypot(...at.map((part, axis) => part - center[axis]!))).toBeLessThan(radius);
  }
});

it('stays while they move in it, and shows the ground when one leaves it', () => {
  const framing = new Framing();
  const first = framing.around(MARKERS, 1);
  expect(framing.around([thing([0, 0, 0.7])], 1)).toBe(first);
  expect(framing.around([thing([0.9, 0, 0]), MARKERS[0]!], 1)).toEqual(WHOLE);
  expect(framing.around(MARKERS, 1)).toEqual(WHOLE);
  framing.clear();
  expect(framing.around(MARKERS, 1)).toEqual(first);
});

it('never shows more than the ground', () => {
  expect(new Framing().around([thing([1, 0, 0]), thing([-1, 0, 0])], 1)).toEqual(WHOLE);
});
